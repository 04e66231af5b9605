#include "gltf/materials.h"

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gltf/model.h"
#include "scene/material_override.h"

namespace vkpt::gltf {
namespace {

constexpr int kUvSets = 2;

template <glm::length_t n>
glm::vec<n, float> toVector(const std::vector<double>& values) {
    glm::vec<n, float> result;
    for (glm::length_t i = 0; i < n; ++i) result[i] = static_cast<float>(values[static_cast<std::size_t>(i)]);
    return result;
}

glm::vec2 vectorOr(const tinygltf::Value& object, const std::string& key, glm::vec2 fallback) {
    if (!object.Has(key)) return fallback;
    const tinygltf::Value& v = object.Get(key);
    return {v.Get(0).GetNumberAsDouble(), v.Get(1).GetNumberAsDouble()};
}

Wrap wrapMode(const Document& document, int sampler, const char* key, int mode) {
    switch (mode) {
        case TINYGLTF_TEXTURE_WRAP_REPEAT:
            return Wrap::Repeat;
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return Wrap::ClampToEdge;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return Wrap::MirroredRepeat;
        default:
            document.fail("samplers[{}].{}: is no wrap mode of glTF", sampler, key);
    }
}

// The affine map translate(offset) rotate(rotation) scale(scale) as rows. Rotation is counter-clockwise as seen with V
// pointing down, as KHR_texture_transform's text and its reference viewer have it.
void applyTransform(const tinygltf::Value& transform, TextureUse& use) {
    const auto offset = vectorOr(transform, "offset", glm::vec2(0));
    const auto scale = vectorOr(transform, "scale", glm::vec2(1));
    const auto angle = static_cast<float>(numberOr(transform, "rotation", 0));
    const float c = std::cos(angle), s = std::sin(angle);
    use.rowU = {c * scale.x, s * scale.y, offset.x};
    use.rowV = {-s * scale.x, c * scale.y, offset.y};
}

// Reads a material's texture slot; leaves `use` empty where the slot is absent or cannot be read.
template <typename TextureInfo>
void readSlot(const Document& document, const std::string& place, std::string_view slot, const TextureInfo& info,
              TextureUse& use, std::vector<std::string>& warnings) {
    if (info.index < 0) return;
    const tinygltf::Value& transform = extension(info.extensions, "KHR_texture_transform");
    const int uvSet = static_cast<int>(numberOr(transform, "texCoord", info.texCoord));
    if (uvSet >= kUvSets) {
        warnings.push_back(
            fmt::format("{}.{}: left out; TEXCOORD_{} is not supported, only 0 and 1", place, slot, uvSet));
        return;
    }
    const tinygltf::Model& model = document.model();
    const tinygltf::Texture& texture = model.textures[info.index];
    if (texture.source < 0) {
        warnings.push_back(
            fmt::format("{}.{}: left out; textures[{}] has no PNG or JPEG source", place, slot, info.index));
        return;
    }
    use.image = texture.source;
    use.uvSet = static_cast<std::uint32_t>(uvSet);
    if (texture.sampler >= 0) {
        const tinygltf::Sampler& sampler = model.samplers[texture.sampler];
        use.wrapS = wrapMode(document, texture.sampler, "wrapS", sampler.wrapS);
        use.wrapT = wrapMode(document, texture.sampler, "wrapT", sampler.wrapT);
        use.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    if (transform.IsObject()) applyTransform(transform, use);
}

AlphaMode alphaMode(const Document& document, const std::string& place, const std::string& mode) {
    if (mode == "OPAQUE") return AlphaMode::Opaque;
    if (mode == "MASK") return AlphaMode::Mask;
    if (mode == "BLEND") return AlphaMode::Blend;
    document.fail("{}.alphaMode: \"{}\" is none of OPAQUE, MASK, BLEND", place, mode);
}

nlohmann::ordered_json toJson(const tinygltf::Value& value) {
    if (value.IsBool()) return value.Get<bool>();
    if (value.IsInt()) return value.GetNumberAsInt();
    if (value.IsNumber()) return value.GetNumberAsDouble();
    if (value.IsString()) return value.Get<std::string>();
    nlohmann::ordered_json json;
    if (value.IsArray())
        for (std::size_t i = 0; i < value.ArrayLen(); ++i) json.push_back(toJson(value.Get(static_cast<int>(i))));
    if (value.IsObject())
        for (const std::string& key : value.Keys()) json[key] = toJson(value.Get(key));
    return json;
}

void readBsdf(const Document& document, const std::string& place, const tinygltf::Value& value, Material& material) {
    if (value.Type() == tinygltf::NULL_TYPE) return;
    try {
        setBsdf(material, bsdfFromJson(toJson(value)));
    } catch (const std::invalid_argument& fault) {
        document.fail("{}.extensions.VKPT_materials_bsdf.{}", place, fault.what());
    }
}

std::array<TextureUse*, 4> slots(Material& material) {
    return {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
            &material.emissiveTexture};
}

}  // namespace

Material readMaterial(const Document& document, std::size_t index, std::vector<std::string>& warnings) {
    const tinygltf::Material& source = document.model().materials[index];
    const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
    const std::string place = fmt::format("materials[{}]", index);
    Material material;
    material.name = source.name;
    material.baseColor = toVector<4>(pbr.baseColorFactor);
    material.metallic = static_cast<float>(pbr.metallicFactor);
    material.roughness = static_cast<float>(pbr.roughnessFactor);
    const double strength =
        numberOr(extension(source.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
    material.emissive = toVector<3>(source.emissiveFactor) * static_cast<float>(strength);
    material.normalScale = static_cast<float>(source.normalTexture.scale);
    material.alphaMode = alphaMode(document, place, source.alphaMode);
    material.alphaCutoff = static_cast<float>(source.alphaCutoff);
    material.doubleSided = source.doubleSided;
    readBsdf(document, place, extension(source.extensions, "VKPT_materials_bsdf"), material);
    material.unlit = source.extensions.contains("KHR_materials_unlit");

    const std::string pbrPlace = place + ".pbrMetallicRoughness";
    readSlot(document, pbrPlace, "baseColorTexture", pbr.baseColorTexture, material.baseColorTexture, warnings);
    readSlot(document, pbrPlace, "metallicRoughnessTexture", pbr.metallicRoughnessTexture,
             material.metallicRoughnessTexture, warnings);
    readSlot(document, place, "normalTexture", source.normalTexture, material.normalTexture, warnings);
    readSlot(document, place, "emissiveTexture", source.emissiveTexture, material.emissiveTexture, warnings);
    return material;
}

std::vector<std::size_t> collectImages(const Document& document, std::vector<Material>& materials) {
    std::vector<int> position(document.model().images.size(), -1);
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
