// The properties that vkpt reads, as the specification and the extensions define them. For schema.cpp alone.
#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace vkpt::gltf {

enum class Kind {
    Array,      // anything in it
    AnyObject,  // checked where it is read
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

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRightAngle = 1.5707963705062866;             // pi / 2 as a float, rounded up
constexpr double kTiny = std::numeric_limits<float>::min();    // stands for "more than 0"
constexpr std::size_t kLargestInteger = std::size_t{1} << 53;  // beyond it JSON numbers are not exact

struct Field {
    std::string_view name;
    Kind kind;
    bool required = false;
    std::string_view section = {};
    const Field* fields = nullptr;  // of an Object
    std::size_t length = 0;         // number of `fields`, or of Numbers
    std::size_t least = 0, most = kLargestInteger;
    double low = -kInfinity, high = kInfinity;  // of a Number or of each of the Numbers
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
constexpr Field number(std::string_view name, double low = -kInfinity, double high = kInfinity,
                       bool required = kOptional) {
    return {.name = name, .kind = Kind::Number, .required = required, .low = low, .high = high};
}
constexpr Field numbers(std::string_view name, std::size_t length, double low = -kInfinity, double high = kInfinity) {
    return {.name = name, .kind = Kind::Numbers, .length = length, .low = low, .high = high};
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

// Leaves first. Named as in the specification [glTF 2.0, §5] and its extensions.

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
constexpr std::array kTextureTransform{numbers("offset", 2), number("rotation"), numbers("scale", 2),
                                       smallSize("texCoord")};
constexpr std::array kTextureInfoExtensions{object("KHR_texture_transform", kTextureTransform)};
constexpr std::array kTextureInfo{index("index", "textures", kRequired), smallSize("texCoord"), number("scale"),
                                  object("extensions", kTextureInfoExtensions)};
constexpr std::array kMetallicRoughness{numbers("baseColorFactor", 4, 0, 1), number("metallicFactor", 0, 1),
                                        number("roughnessFactor", 0, 1), object("baseColorTexture", kTextureInfo),
                                        object("metallicRoughnessTexture", kTextureInfo)};
constexpr std::array kEmissiveStrength{number("emissiveStrength", 0)};
constexpr Type<0> kUnlit{};
constexpr std::array kMaterialExtensions{object("KHR_materials_emissive_strength", kEmissiveStrength),
                                         object("KHR_materials_unlit", kUnlit),
                                         plain("VKPT_materials_bsdf", Kind::AnyObject)};
constexpr std::array kMaterial{plain("name", Kind::String),
                               object("pbrMetallicRoughness", kMetallicRoughness),
                               object("normalTexture", kTextureInfo),
                               object("emissiveTexture", kTextureInfo),
                               numbers("emissiveFactor", 3, 0, 1),
                               plain("alphaMode", Kind::String),
                               number("alphaCutoff", 0),
                               plain("doubleSided", Kind::Boolean),
                               object("extensions", kMaterialExtensions)};

constexpr std::array kPrimitive{indexMap("attributes", "accessors"), index("indices", "accessors"),
                                index("material", "materials"), smallSize("mode"), plain("targets", Kind::Array)};
constexpr std::array kMesh{plain("name", Kind::String), objects("primitives", kPrimitive, kRequired, 1)};

constexpr std::array kPerspective{number("yfov", kTiny, kInfinity, kRequired), number("aspectRatio", kTiny)};
constexpr std::array kOrthographic{number("xmag", -kInfinity, kInfinity, kRequired),
                                   number("ymag", -kInfinity, kInfinity, kRequired)};
constexpr std::array kCamera{plain("name", Kind::String), plain("type", Kind::String, kRequired),
                             object("perspective", kPerspective), object("orthographic", kOrthographic)};
constexpr std::array kSpot{number("innerConeAngle", 0, kRightAngle), number("outerConeAngle", kTiny, kRightAngle)};
constexpr std::array kLight{plain("name", Kind::String), plain("type", Kind::String, kRequired),
                            numbers("color", 3, 0, 1),   number("intensity", 0),
                            number("range", kTiny),      object("spot", kSpot)};
constexpr std::array kLights{objects("lights", kLight, kRequired)};
constexpr std::array kLightUse{smallSize("light", kRequired)};
constexpr std::array kNodeExtensions{object("KHR_lights_punctual", kLightUse)};
constexpr std::array kNode{
    plain("name", Kind::String),   indices("children", "nodes"), index("mesh", "meshes"),
    index("camera", "cameras"),    numbers("matrix", 16),        numbers("translation", 3),
    numbers("rotation", 4, -1, 1), numbers("scale", 3),          object("extensions", kNodeExtensions)};
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

}  // namespace vkpt::gltf
