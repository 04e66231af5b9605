#include "gltf/rules.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/error.h"

namespace vkpt::gltf {
namespace {

using Json = nlohmann::json;

constexpr double kUnitTolerance = 0.01;   // of a squared length: quaternions may come from bytes
constexpr double kShearTolerance = 1e-3;  // cosine of the angle between two axes

class Rules {
public:
    Rules(const Json& root, const std::string& file) : root_(root), file_(file) {}

    void check() const {
        each("accessors", [&](const Json& accessor) {
            if (!accessor.contains("bufferView") && accessor.contains("byteOffset"))
                return "has a byteOffset but no bufferView";
            return kFine;
        });
        each("images", [&](const Json& image) {
            if (image.contains("uri") && image.contains("bufferView")) return "has both uri and bufferView";
            return image.contains("uri") || image.contains("bufferView") ? kFine : "has neither uri nor bufferView";
        });
        each("cameras", checkCamera);
        each("nodes", checkNode);
        if (root_.contains("/extensions/KHR_lights_punctual"_json_pointer))
            each("extensions.KHR_lights_punctual.lights", root_["extensions"]["KHR_lights_punctual"]["lights"],
                 checkLight);
    }

private:
    static constexpr const char* kFine = nullptr;

    template <typename Fault>
    void each(const char* section, Fault&& faultOf) const {
        if (root_.contains(section)) each(section, root_[section], faultOf);
    }

    /// Throws for the first item that faultOf finds fault with.
    template <typename Fault>
    void each(const char* place, const Json& items, Fault&& faultOf) const {
        for (std::size_t i = 0; i < items.size(); ++i)
            if (const char* fault = faultOf(items[i]))
                throw FileError(file_, fmt::format("{}[{}]: {}", place, i, fault));
    }

    static const char* checkCamera(const Json& camera) {
        const bool perspective = camera.contains("perspective"), orthographic = camera.contains("orthographic");
        const auto& type = camera["type"].get_ref<const std::string&>();
        if ((type != "perspective" || !perspective) && (type != "orthographic" || !orthographic))
            return "must be perspective or orthographic and have the object of that name";
        if (perspective && orthographic) return "has both a perspective and an orthographic object";
        if (orthographic && (camera["orthographic"]["xmag"] == 0 || camera["orthographic"]["ymag"] == 0))
            return "xmag and ymag must not be 0";
        return kFine;
    }

    static const char* checkNode(const Json& node) {
        if (node.contains("rotation")) {
            double squared = 0;
            for (const Json& x : node["rotation"]) squared += x.get<double>() * x.get<double>();
            if (std::abs(squared - 1) > kUnitTolerance) return "rotation is no unit quaternion";
        }
        if (!node.contains("matrix")) return kFine;
        if (node.contains("translation") || node.contains("rotation") || node.contains("scale"))
            return "has a matrix beside translation, rotation or scale";
        return checkMatrix(node["matrix"]);
    }

    /// A node's matrix is a translation, a rotation and a scale. [glTF 2.0, §3.5.3]
    static const char* checkMatrix(const Json& matrix) {
        const auto at = [&](std::size_t column, std::size_t row) { return matrix[4 * column + row].get<double>(); };
        if (at(0, 3) != 0 || at(1, 3) != 0 || at(2, 3) != 0 || at(3, 3) != 1)
            return "the last row of its matrix is not 0, 0, 0, 1";
        const auto dot = [&](std::size_t a, std::size_t b) {
            return at(a, 0) * at(b, 0) + at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2);
        };
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t other = (axis + 1) % 3;
            if (std::abs(dot(axis, other)) > kShearTolerance * std::sqrt(dot(axis, axis) * dot(other, other)))
                return "its matrix shears";
        }
        return kFine;
    }

    static const char* checkLight(const Json& light) {
        const auto& type = light["type"].get_ref<const std::string&>();
        if (type != "point" && type != "spot" && type != "directional")
            return "type is none of point, spot, directional";
        if (type != "spot") return kFine;
        if (!light.contains("spot")) return "is a spot without the object of that name";
        // Equal angles make a hard edge: exporters write them, and there is no doubt what they mean.
        const Json& spot = light["spot"];
        return spot.value("innerConeAngle", 0.0) > spot.value("outerConeAngle", kDefaultOuterCone)
                   ? "innerConeAngle is greater than outerConeAngle"
                   : kFine;
    }

    static constexpr double kDefaultOuterCone = 0.78539816339744831;  // pi / 4

    const Json& root_;
    const std::string& file_;
};

/// Names of all extension objects below `value`.
void collectExtensions(const Json& value, std::set<std::string>& names) {
    if (!value.is_structured()) return;
    for (const auto& item : value.items()) {
        if (value.is_object() && item.key() == "extensions" && item.value().is_object())
            for (const auto& extension : item.value().items()) names.insert(extension.key());
        collectExtensions(item.value(), names);
    }
}

}  // namespace

std::vector<std::string> checkRules(const Json& root, const std::string& file) {
    Rules(root, file).check();

    std::vector<std::string> warnings;
    std::set<std::string> used, declared;
    collectExtensions(root, used);
    for (const Json& name : root.value("extensionsUsed", Json::array()))
        if (!declared.insert(name).second)
            warnings.push_back(fmt::format("extensionsUsed: names {} more than once", name.get<std::string>()));
    for (const std::string& name : used)
        if (!declared.contains(name))
            warnings.push_back(fmt::format("extensionsUsed: does not name {}, which the file uses", name));
    return warnings;
}

}  // namespace vkpt::gltf
