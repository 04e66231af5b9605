#include "gltf/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "base/error.h"

namespace vkpt::gltf {
namespace {

using Json = nlohmann::json;

enum class Kind {
    Array,  // anything in it
    Boolean,
    Index,     // into the root's array named by `section`
    Indices,   // array of them
    IndexMap,  // object of them
    Number,
    Numbers,  // array of `length` numbers
    Object,   // of `type`
    Objects,  // array of them
    Size,     // integer from `least` up
    String,
    Strings,
};

constexpr std::size_t kLargestInteger = std::size_t{1} << 53;  // beyond it JSON numbers are not exact

struct Field {
    std::string_view name;
    Kind kind;
    bool required = false;
    std::string_view section = {};
    const Field* fields = nullptr;  // of an Object
    std::size_t length = 0;         // number of `fields`, or of Numbers
    std::size_t least = 0, most = kLargestInteger;
};

constexpr bool kRequired = true, kOptional = false;

template <std::size_t n>
using Type = std::array<Field, n>;

constexpr Field plain(std::string_view name, Kind kind, bool required = kOptional) {
    return {.name = name, .kind = kind, .required = required};
}
constexpr Field index(std::string_view name, std::string_view section, bool required = kOptional) {
    return {.name = name, .kind = Kind::Index, .required = required, .section = section};
}
constexpr Field indices(std::string_view name, std::string_view section) {
    return {.name = name, .kind = Kind::Indices, .section = section};
}
constexpr Field indexMap(std::string_view name, std::string_view section) {
    return {.name = name, .kind = Kind::IndexMap, .required = kRequired, .section = section};
}
constexpr Field size(std::string_view name, bool required = kOptional, std::size_t least = 0) {
    return {.name = name, .kind = Kind::Size, .required = required, .least = least};
}
constexpr Field numbers(std::string_view name, std::size_t length) {
    return {.name = name, .kind = Kind::Numbers, .length = length};
}
// A size that tinygltf keeps in an int.
constexpr Field smallSize(std::string_view name, bool required = kOptional, std::size_t least = 0) {
    return {.name = name, .kind = Kind::Size, .required = required, .least = least, .most = 0x7fffffff};
}
template <std::size_t n>
constexpr Field object(std::string_view name, const Type<n>& type, bool required = kOptional) {
    return {.name = name, .kind = Kind::Object, .required = required, .fields = type.data(), .length = n};
}
template <std::size_t n>
constexpr Field objects(std::string_view name, const Type<n>& type, bool required = kOptional, std::size_t least = 0) {
    return {
        .name = name, .kind = Kind::Objects, .required = required, .fields = type.data(), .length = n, .least = least};
}

// ---- the tables, leaves first. Named as in the specification [glTF 2.0, §5] and its extensions ---------------

constexpr std::array kAsset{plain("version", Kind::String, kRequired), plain("minVersion", Kind::String)};
constexpr std::array kBuffer{plain("uri", Kind::String), size("byteLength", kRequired, 1)};
constexpr std::array kBufferView{index("buffer", "buffers", kRequired), size("byteOffset"),
                                 size("byteLength", kRequired, 1), size("byteStride", kOptional, 1)};
constexpr std::array kSparseIndices{index("bufferView", "bufferViews", kRequired), smallSize("byteOffset"),
                                    smallSize("componentType", kRequired)};
constexpr std::array kSparseValues{index("bufferView", "bufferViews", kRequired), smallSize("byteOffset")};
constexpr std::array kSparse{smallSize("count", kRequired, 1), object("indices", kSparseIndices, kRequired),
                             object("values", kSparseValues, kRequired)};
constexpr std::array kAccessor{
    index("bufferView", "bufferViews"), size("byteOffset"),          smallSize("componentType", kRequired),
    plain("normalized", Kind::Boolean), size("count", kRequired, 1), plain("type", Kind::String, kRequired),
    object("sparse", kSparse)};

constexpr std::array kImage{plain("uri", Kind::String), index("bufferView", "bufferViews"),
                            plain("mimeType", Kind::String), plain("name", Kind::String)};
constexpr std::array kSampler{smallSize("magFilter"), smallSize("minFilter"), smallSize("wrapS"), smallSize("wrapT")};
constexpr std::array kTexture{index("source", "images"), index("sampler", "samplers")};
constexpr std::array kTextureTransform{numbers("offset", 2), plain("rotation", Kind::Number), numbers("scale", 2),
                                       smallSize("texCoord")};
constexpr std::array kTextureInfoExtensions{object("KHR_texture_transform", kTextureTransform)};
constexpr std::array kTextureInfo{index("index", "textures", kRequired), smallSize("texCoord"),
                                  plain("scale", Kind::Number), object("extensions", kTextureInfoExtensions)};
constexpr std::array kMetallicRoughness{
    numbers("baseColorFactor", 4), plain("metallicFactor", Kind::Number), plain("roughnessFactor", Kind::Number),
    object("baseColorTexture", kTextureInfo), object("metallicRoughnessTexture", kTextureInfo)};
constexpr std::array kEmissiveStrength{plain("emissiveStrength", Kind::Number)};
constexpr Type<0> kUnlit{};
constexpr std::array kMaterialExtensions{object("KHR_materials_emissive_strength", kEmissiveStrength),
                                         object("KHR_materials_unlit", kUnlit)};
constexpr std::array kMaterial{plain("name", Kind::String),
                               object("pbrMetallicRoughness", kMetallicRoughness),
                               object("normalTexture", kTextureInfo),
                               object("emissiveTexture", kTextureInfo),
                               numbers("emissiveFactor", 3),
                               plain("alphaMode", Kind::String),
                               plain("alphaCutoff", Kind::Number),
                               plain("doubleSided", Kind::Boolean),
                               object("extensions", kMaterialExtensions)};

constexpr std::array kPrimitive{indexMap("attributes", "accessors"), index("indices", "accessors"),
                                index("material", "materials"), smallSize("mode"), plain("targets", Kind::Array)};
constexpr std::array kMesh{plain("name", Kind::String), objects("primitives", kPrimitive, kRequired, 1)};

constexpr std::array kPerspective{plain("yfov", Kind::Number, kRequired), plain("aspectRatio", Kind::Number)};
constexpr std::array kOrthographic{plain("xmag", Kind::Number, kRequired), plain("ymag", Kind::Number, kRequired)};
constexpr std::array kCamera{plain("name", Kind::String), plain("type", Kind::String, kRequired),
                             object("perspective", kPerspective), object("orthographic", kOrthographic)};
constexpr std::array kSpot{plain("innerConeAngle", Kind::Number), plain("outerConeAngle", Kind::Number)};
constexpr std::array kLight{plain("name", Kind::String),  plain("type", Kind::String, kRequired),
                            numbers("color", 3),          plain("intensity", Kind::Number),
                            plain("range", Kind::Number), object("spot", kSpot)};
constexpr std::array kLights{objects("lights", kLight, kRequired)};
constexpr std::array kLightUse{smallSize("light", kRequired)};
constexpr std::array kNodeExtensions{object("KHR_lights_punctual", kLightUse)};
constexpr std::array kNode{
    plain("name", Kind::String), indices("children", "nodes"), index("mesh", "meshes"),
    index("camera", "cameras"),  numbers("matrix", 16),        numbers("translation", 3),
    numbers("rotation", 4),      numbers("scale", 3),          object("extensions", kNodeExtensions)};
constexpr std::array kScene{plain("name", Kind::String), indices("nodes", "nodes")};
constexpr std::array kRootExtensions{object("KHR_lights_punctual", kLights)};
constexpr std::array kRoot{object("asset", kAsset, kRequired),
                           plain("extensionsUsed", Kind::Strings),
                           plain("extensionsRequired", Kind::Strings),
                           objects("buffers", kBuffer),
                           objects("bufferViews", kBufferView),
                           objects("accessors", kAccessor),
                           objects("images", kImage),
                           objects("samplers", kSampler),
                           objects("textures", kTexture),
                           objects("materials", kMaterial),
                           objects("meshes", kMesh),
                           objects("cameras", kCamera),
                           objects("nodes", kNode),
                           objects("scenes", kScene),
                           index("scene", "scenes"),
                           plain("animations", Kind::Array),
                           plain("skins", Kind::Array),
                           object("extensions", kRootExtensions)};

// ---- the walk -------------------------------------------------------------------------------------------------

// glTF allows integers in floating-point form (5126.0). [glTF 2.0, §2.7]
bool isSize(const Json& value, std::size_t least, std::size_t most) {
    if (!value.is_number()) return false;
    const auto number = value.get<double>();
    return number >= static_cast<double>(least) && number <= static_cast<double>(most) && number == std::floor(number);
}

bool isFiniteFloat(const Json& value) {
    return value.is_number() && std::isfinite(static_cast<float>(value.get<double>()));
}

class Checker {
public:
    Checker(Json& root, const std::string& file) : root_(root), file_(file) {}

    void object(Json& value, std::span<const Field> fields) {
        if (!value.is_object()) fail("must be an object");
        for (auto item = value.begin(); item != value.end();) {
            const auto known = [&](const Field& field) { return field.name == item.key(); };
            item = std::any_of(fields.begin(), fields.end(), known) ? std::next(item) : value.erase(item);
        }
        for (const Field& field : fields) {
            const std::size_t length = path_.size();
            path_ += path_.empty() ? "" : ".";
            path_ += field.name;
            const auto found = value.find(field.name);
            if (found != value.end())
                member(*found, field);
            else if (field.required)
                fail("is missing");
            path_.resize(length);
        }
    }

private:
    void member(Json& value, const Field& field) {
        switch (field.kind) {
            case Kind::Array:
                return elements(value, [](Json& item) { item = Json::object(); });
            case Kind::Boolean:
                return require(value.is_boolean(), "must be true or false");
            case Kind::Index:
                return indexInto(value, field.section);
            case Kind::Indices:
                return elements(value, [&](Json& item) { indexInto(item, field.section); });
            case Kind::IndexMap:
                return indexMap(value, field.section);
            case Kind::Number:
                return number(value);
            case Kind::Numbers:
                if (!value.is_array() || value.size() != field.length)
                    fail(fmt::format("must be an array of {} numbers", field.length));
                return elements(value, [&](Json& item) { number(item); });
            case Kind::Object:
                return object(value, {field.fields, field.length});
            case Kind::Objects:
                elements(value, [&](Json& item) { object(item, {field.fields, field.length}); });
                return require(value.size() >= field.least, "must not be empty");
            case Kind::Size:
                if (!isSize(value, field.least, field.most))
                    fail(field.most == kLargestInteger
                             ? fmt::format("must be an integer from {} up", field.least)
                             : fmt::format("must be an integer from {} to {}", field.least, field.most));
                value = value.get<std::size_t>();
                return;
            case Kind::String:
                return require(value.is_string(), "must be a string");
            case Kind::Strings:
                return elements(value, [&](const Json& item) { require(item.is_string(), "must be a string"); });
        }
    }

    template <typename Visit>
    void elements(Json& value, Visit&& visit) {
        require(value.is_array(), "must be an array");
        std::size_t i = 0;
        const std::size_t length = path_.size();
        for (Json& item : value) {
            fmt::format_to(std::back_inserter(path_), "[{}]", i++);
            visit(item);
            path_.resize(length);
        }
    }

    void indexMap(Json& value, std::string_view section) {
        require(value.is_object(), "must be an object");
        const std::size_t length = path_.size();
        for (auto item = value.begin(); item != value.end(); ++item) {
            path_ += "." + item.key();
            indexInto(*item, section);
            path_.resize(length);
        }
    }

    void number(Json& value) {
        if (!isFiniteFloat(value)) fail("must be a number");
        value = value.get<double>();
    }

    void indexInto(Json& value, std::string_view section) {
        if (!isSize(value, 0, kLargestInteger)) fail("must be an index");
        const auto found = root_.find(section);
        const std::size_t count = found != root_.end() && found->is_array() ? found->size() : 0;
        if (value.get<std::size_t>() >= count)
            fail(fmt::format("{}, but the file has {} {}", value.get<std::size_t>(), count, section));
        value = value.get<std::size_t>();
    }

    void require(bool holds, std::string_view fault) {
        if (!holds) fail(fault);
    }

    [[noreturn]] void fail(std::string_view fault) {
        throw FileError(file_, path_.empty() ? fmt::format("the file {}", fault) : fmt::format("{}: {}", path_, fault));
    }

    Json& root_;
    const std::string& file_;
    std::string path_;
};

}  // namespace

void checkSchema(nlohmann::json& root, const std::string& file) { Checker(root, file).object(root, kRoot); }

}  // namespace vkpt::gltf
