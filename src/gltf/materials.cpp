#include "gltf/materials.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace vkpt::gltf {
namespace {

constexpr std::size_t kNearest = 9728, kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497;
constexpr std::size_t kUvSets = 2;

template <glm::length_t n>
glm::vec<n, float> vectorOr(const Json& object, std::string_view key, glm::vec<n, float> fallback) {
    const Json& value = member(object, key);
    if (value.is_null()) return fallback;
    for (glm::length_t i = 0; i < n; ++i) fallback[i] = value[static_cast<std::size_t>(i)].template get<float>();
    return fallback;
}

float unit(float value) { return std::clamp(value, 0.0F, 1.0F); }

Wrap wrapMode(const Document& document, std::size_t sampler, const char* key) {
    switch (valueOr(document.item("samplers", sampler), key, kRepeat)) {
        case kRepeat:
            return Wrap::Repeat;
        case kClampToEdge:
            return Wrap::ClampToEdge;
        case kMirroredRepeat:
            return Wrap::MirroredRepeat;
        default:
            document.fail("samplers[{}].{}: is no wrap mode of glTF", sampler, key);
    }
}

// The affine map translate(offset) rotate(rotation) scale(scale) as rows. Rotation is counter-clockwise as seen with V
// pointing down, as KHR_texture_transform's text and its reference viewer have it.
void applyTransform(const Json& transform, TextureUse& use) {
    const auto offset = vectorOr(transform, "offset", glm::vec2(0));
    const auto scale = vectorOr(transform, "scale", glm::vec2(1));
    const float angle = valueOr<float>(transform, "rotation", 0);
    const float c = std::cos(angle), s = std::sin(angle);
    use.rowU = {c * scale.x, s * scale.y, offset.x};
    use.rowV = {-s * scale.x, c * scale.y, offset.y};
}

// Reads a material's texture slot; leaves `use` empty where the slot is absent or cannot be read.
void readSlot(const Document& document, const std::string& place, const Json& owner, std::string_view slot,
              TextureUse& use, std::vector<std::string>& warnings) {
    const Json& info = member(owner, slot);
    if (info.is_null()) return;
    const Json& transform = extension(info, "KHR_texture_transform");
    const std::size_t uvSet = valueOr(transform, "texCoord", valueOr(info, "texCoord", std::size_t{0}));
    if (uvSet >= kUvSets) {
        warnings.push_back(
            fmt::format("{}.{}: left out; TEXCOORD_{} is not supported, only 0 and 1", place, slot, uvSet));
        return;
    }
    const auto textureIndex = member(info, "index").get<std::size_t>();
    const Json& texture = document.item("textures", textureIndex);
    const Json& source = member(texture, "source");
    if (source.is_null()) {
        warnings.push_back(
            fmt::format("{}.{}: left out; textures[{}] has no PNG or JPEG source", place, slot, textureIndex));
        return;
    }
    use.image = source.get<int>();
    use.uvSet = static_cast<std::uint32_t>(uvSet);
    const Json& sampler = member(texture, "sampler");
    if (!sampler.is_null()) {
        const auto index = sampler.get<std::size_t>();
        use.wrapS = wrapMode(document, index, "wrapS");
        use.wrapT = wrapMode(document, index, "wrapT");
        use.nearest = valueOr(document.item("samplers", index), "magFilter", std::size_t{0}) == kNearest;
    }
    if (!transform.is_null()) applyTransform(transform, use);
}

AlphaMode alphaMode(const Document& document, const std::string& place, const Json& object) {
    const std::string mode = textOr(object, "alphaMode", "OPAQUE");
    if (mode == "OPAQUE") return AlphaMode::Opaque;
    if (mode == "MASK") return AlphaMode::Mask;
    if (mode == "BLEND") return AlphaMode::Blend;
    document.fail("{}.alphaMode: \"{}\" is none of OPAQUE, MASK, BLEND", place, mode);
}

std::array<TextureUse*, 4> slots(Material& material) {
    return {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
            &material.emissiveTexture};
}

}  // namespace

Material readMaterial(const Document& document, std::size_t index, std::vector<std::string>& warnings) {
    const Json& object = document.item("materials", index);
    const Json& pbr = member(object, "pbrMetallicRoughness");
    const std::string place = fmt::format("materials[{}]", index);
    Material material;
    material.name = textOr(object, "name", "");
    material.baseColor = glm::clamp(vectorOr(pbr, "baseColorFactor", glm::vec4(1)), 0.0F, 1.0F);
    material.metallic = unit(valueOr<float>(pbr, "metallicFactor", 1));
    material.roughness = unit(valueOr<float>(pbr, "roughnessFactor", 1));
    const float strength = valueOr<float>(extension(object, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
    material.emissive = glm::max(vectorOr(object, "emissiveFactor", glm::vec3(0)) * strength, 0.0F);
    material.normalScale = valueOr<float>(member(object, "normalTexture"), "scale", 1);
    material.alphaMode = alphaMode(document, place, object);
    material.alphaCutoff = std::max(valueOr<float>(object, "alphaCutoff", 0.5F), 0.0F);
    material.doubleSided = valueOr(object, "doubleSided", false);
    material.unlit = !extension(object, "KHR_materials_unlit").is_null();

    const std::string pbrPlace = place + ".pbrMetallicRoughness";
    readSlot(document, pbrPlace, pbr, "baseColorTexture", material.baseColorTexture, warnings);
    readSlot(document, pbrPlace, pbr, "metallicRoughnessTexture", material.metallicRoughnessTexture, warnings);
    readSlot(document, place, object, "normalTexture", material.normalTexture, warnings);
    readSlot(document, place, object, "emissiveTexture", material.emissiveTexture, warnings);
    return material;
}

std::vector<std::size_t> collectImages(const Document& document, std::vector<Material>& materials) {
    std::vector<int> position(document.count("images"), -1);
    for (Material& material : materials)
        for (const TextureUse* use : slots(material))
            if (use->image >= 0) position[static_cast<std::size_t>(use->image)] = 0;
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (position[i] < 0) continue;
        position[i] = static_cast<int>(used.size());
        used.push_back(i);
    }
    for (Material& material : materials)
        for (TextureUse* use : slots(material))
            if (use->image >= 0) use->image = position[static_cast<std::size_t>(use->image)];
    return used;
}

}  // namespace vkpt::gltf
