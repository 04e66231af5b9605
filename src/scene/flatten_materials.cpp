#include "scene/flatten_materials.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "base/math.h"
#include "scene/albedo_tables.h"
#include "scene/texture_layout.h"

namespace vkpt {
namespace {

float minAlpha(const TextureImage& image) {
    std::uint32_t lowest = 255;
    for (const std::uint32_t texel : image.texels) lowest = std::min(lowest, texel >> 24U);
    return static_cast<float>(lowest) / 255.0F;
}

std::uint32_t materialFlags(const Material& material, const MaterialTraits& traits) {
    std::uint32_t flags = 0;
    if (material.alphaMode == AlphaMode::Mask) flags |= kMaterialAlphaMask;
    if (material.alphaMode == AlphaMode::Blend) flags |= kMaterialAlphaBlend;
    if (material.doubleSided) flags |= kMaterialDoubleSided;
    if (material.unlit) flags |= kMaterialUnlit;
    if (traits.vertexColor) flags |= kMaterialVertexColor;
    if (bsdfModel(material) != BsdfId::Gltf && isAnisotropic(*material.bsdf)) flags |= kMaterialTangents;
    return flags | static_cast<std::uint32_t>(bsdfModel(material)) << kMaterialModelShift;
}

/// Slots that cannot change the picture are left empty: they would only cost loads.
MaterialRecord materialRecord(const Scene& scene, const Material& material, const MaterialTraits& traits,
                              TextureLayout& layout) {
    std::array<MaterialMap, kMapRoles> maps;
    const auto read = [&](std::uint32_t role, const TextureUse& use, bool srgb) {
        if (hasImage(scene, use)) maps[role] = {&use, srgb};
    };
    MaterialRecord record{};
    const bool isGltf = bsdfModel(material) == BsdfId::Gltf;
    record.baseColor = isGltf ? material.baseColor : glm::vec4(1, 1, 1, material.baseColor.a);
    record.metallic = std::clamp(material.metallic, 0.0F, 1.0F);
    record.roughness = std::clamp(material.roughness, 0.0F, 1.0F);
    record.normalScale = material.normalScale;
    record.alphaCutoff = material.alphaCutoff;
    record.flags = materialFlags(material, traits);
    if (traits.used) read(kMapBaseColor, material.baseColorTexture, true);
    if (traits.used && !material.unlit) {
        if (!isGltf || record.metallic > 0 || record.roughness > 0)
            read(kMapMetallicRoughness, material.metallicRoughnessTexture, false);
        read(kMapNormal, material.normalTexture, false);
        if (traits.emissive) {
            record.emissive = material.emissive;
            read(kMapEmissive, material.emissiveTexture, true);
        }
    }
    layout.add(maps, record);
    return record;
}

/// One BsdfRecord a material, unless all are glTF's; and the albedo tables.
void addBsdfs(const Scene& scene, const std::vector<MaterialTraits>& traits, bool multiscatter, SceneArrays& arrays) {
    arrays.features.multiscatter = multiscatter;
    AlbedoTables tables(multiscatter);
    std::uint32_t models = 0;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        const BsdfId model = bsdfModel(material);
        if (!traits[i].used) continue;
        models |= 1U << static_cast<std::uint32_t>(model);
        if (model == BsdfId::Gltf) continue;
        arrays.bsdfs.resize(scene.materials.size(), bsdfRecord({}));
        arrays.bsdfs[i] = bsdfRecord(*material.bsdf);
        arrays.features.media |= model == BsdfId::Dielectric && arrays.bsdfs[i].diffuse != glm::vec3(0);
        tables.add(model, hasImage(scene, material.metallicRoughnessTexture), arrays.bsdfs[i]);
    }
    if (models != 0) arrays.features.bsdfModels = models;
    arrays.albedoTables = tables.take();
}

}  // namespace

BsdfId bsdfModel(const Material& material) {
    return material.bsdf && !material.unlit ? material.bsdf->model : BsdfId::Gltf;
}

bool hasImage(const Scene& scene, const TextureUse& use) {
    return use.image >= 0 && static_cast<std::size_t>(use.image) < scene.images.size() &&
           !scene.images[static_cast<std::size_t>(use.image)].texels.empty();
}

std::vector<MaterialTraits> materialTraits(const Scene& scene) {
    std::vector<MaterialTraits> traits(scene.materials.size());
    for (const MeshInstance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes[instance.mesh].primitives) {
            traits[primitive.material].used = true;
            traits[primitive.material].vertexColor |= !primitive.colors.empty();
        }
    }
    tbb::parallel_for(std::size_t{0}, traits.size(), [&](std::size_t i) {
        const Material& material = scene.materials[i];
        traits[i].emissive = !material.unlit && luminance(material.emissive) > 0;
        if (traits[i].used && material.alphaMode != AlphaMode::Opaque && hasImage(scene, material.baseColorTexture)) {
            traits[i].minTextureAlpha =
                minAlpha(scene.images[static_cast<std::size_t>(material.baseColorTexture.image)]);
        }
    });
    return traits;
}

void flattenMaterials(const Scene& scene, const std::vector<MaterialTraits>& traits, bool multiscatter,
                      SceneArrays& arrays) {
    addBsdfs(scene, traits, multiscatter, arrays);
    TextureLayout layout(scene, arrays);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const MaterialRecord record = materialRecord(scene, scene.materials[i], traits[i], layout);
        arrays.features.unlit |= traits[i].used && scene.materials[i].unlit;
        arrays.materials.push_back(record);
        arrays.materialNames.push_back(scene.materials[i].name);
    }
    layout.copyTexels();
    arrays.features.textureTransforms = std::ranges::any_of(arrays.textures, [](const TextureRecord& t) {
        return t.rowU != glm::vec4(1, 0, 0, 0) || t.rowV != glm::vec4(0, 1, 0, 0);
    });
}

}  // namespace vkpt
