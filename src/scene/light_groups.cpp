#include "scene/light_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "scene/light_layers.h"

namespace vkpt {
namespace {

bool shines(const SceneArrays& arrays, const TriangleRecord& triangle) {
    const MaterialRecord& material = arrays.materials[triangle.flags >> kTriangleMaterialShift];
    return material.emissive != glm::vec3(0) || (material.flags & kMaterialUnlit) != 0;
}

/// Of each mesh instance, whether some triangle of it gives light.
std::vector<bool> shiningObjects(const SceneArrays& arrays) {
    std::vector<bool> shining(arrays.objectNames.size());
    const auto visit = [&](const MeshRange& range, std::uint32_t object) {
        for (std::uint32_t i = 0; i < range.triangleCount; ++i) {
            const TriangleRecord& triangle = arrays.triangles[range.firstTriangle + i];
            if (shines(arrays, triangle)) shining[object == kNone ? triangle.object : object] = true;
        }
    };
    if (arrays.instances.empty()) visit(arrays.meshRanges.at(0), kNone);
    for (std::size_t i = 0; i < arrays.instances.size(); ++i)
        visit(arrays.meshRanges[arrays.instanceMesh[i]], arrays.instances[i].object);
    return shining;
}

/// Gives names numbers, in the order in which they come.
class GroupNames {
public:
    explicit GroupNames(const std::vector<std::string>& wanted) : wanted_(wanted) {}

    std::uint32_t idOf(const std::string& name) {
        seen_.insert(name);
        const bool chosen = wanted_.empty() || std::ranges::find(wanted_, name) != wanted_.end();
        const std::string& group = chosen ? name : others_;
        const auto known = std::ranges::find(names_, group);
        const auto id = static_cast<std::uint32_t>(known - names_.begin());
        if (known == names_.end()) names_.push_back(group);
        return id;
    }
    /// Throws as groupLights does.
    void check(const std::string& file) const {
        if (names_.empty()) throw FileError(file, "--light-groups: nothing shines in this scene");
        if (names_.size() > kMostLightGroups)
            throw FileError(file,
                            fmt::format("--light-groups: {} names of lights, {} groups are possible; choose some, "
                                        "--light-groups A,B,...: the rest become '{}'",
                                        names_.size(), kMostLightGroups, kOtherLights));
        for (const std::string& name : wanted_)
            if (!seen_.contains(name))
                throw Error(ExitCode::Usage,
                            printable(fmt::format("--light-groups: nothing that shines is called '{}'; "
                                                  "there are {}",
                                                  name, known())));
    }
    [[nodiscard]] std::vector<std::string> take() { return std::move(names_); }

private:
    [[nodiscard]] std::string known() const {
        constexpr std::size_t kMost = 20;
        std::string text;
        std::size_t count = 0;
        for (const std::string& name : seen_) {
            if (count++ == kMost) return text + ", …";
            text += (text.empty() ? "" : ", ") + name;
        }
        return text;
    }

    const std::vector<std::string>& wanted_;
    const std::string others_ = kOtherLights;
    std::vector<std::string> names_;
    std::set<std::string> seen_;
};

std::string nameOr(const std::string& name, const char* kind, std::size_t number) {
    return name.empty() ? fmt::format("{}{}", kind, number) : name;
}

}  // namespace

void groupLights(SceneArrays& arrays, const LightGroupChoice& choice, bool backgroundShines, const std::string& file) {
    LightGroups groups;
    GroupNames names(choice.names);
    const std::vector<bool> shining = shiningObjects(arrays);
    groups.ofObject.resize(shining.size());
    for (std::size_t i = 0; i < shining.size(); ++i)
        if (shining[i]) groups.ofObject[i] = names.idOf(nameOr(arrays.objectNames[i], "mesh", i));
    std::size_t punctual = 0;
    for (const LightRecord& light : arrays.lights) {
        if (light.kind <= kLightTriangleTwoSided) {
            groups.ofLight.push_back(groups.ofObject[arrays.triangles[light.index].object]);
        } else if (light.kind == kLightEnvironment) {
            groups.ofLight.push_back(names.idOf(kEnvironmentGroup));
        } else {
            groups.ofLight.push_back(names.idOf(nameOr(arrays.punctualNames[punctual], "light", punctual)));
            ++punctual;
        }
    }
    if (arrays.features.environment || backgroundShines) groups.behind = names.idOf(kEnvironmentGroup);
    names.check(file);
    groups.names = names.take();
    arrays.lightGroups = std::move(groups);
}

}  // namespace vkpt
