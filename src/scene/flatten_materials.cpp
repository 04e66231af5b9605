#include "scene/flatten_materials.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

#include "base/error.h"
#include "base/math.h"

namespace vkpt {
namespace {

float minAlpha(const TextureImage& image) {
    std::uint32_t lowest = 255;
    for (const std::uint32_t texel : image.texels) lowest = std::min(lowest, texel >> 24U);
    return static_cast<float>(lowest) / 255.0F;
}

std::uint32_t wrapBits(Wrap wrap) {
    if (wrap == Wrap::ClampToEdge) return kWrapClamp;
    return wrap == Wrap::MirroredRepeat ? kWrapMirror : kWrapRepeat;
}

std::uint32_t materialFlags(const Material& material, const MaterialTraits& traits) {
    std::uint32_t flags = 0;
    if (material.alphaMode == AlphaMode::Mask) flags |= kMaterialAlphaMask;
    if (material.alphaMode == AlphaMode::Blend) flags |= kMaterialAlphaBlend;
    if (material.doubleSided) flags |= kMaterialDoubleSided;
    if (material.unlit) flags |= kMaterialUnlit;
    if (traits.vertexColor) flags |= kMaterialVertexColor;
    return flags;
}

/// Lays out the images that are read, and makes the texture records that refer to them.
class TextureLayout {
public:
    TextureLayout(const Scene& scene, SceneArrays& arrays)
        : scene_(scene), arrays_(arrays), firstTexel_(scene.images.size(), kNone) {}

    /// Index of a new TextureRecord, or kNone where the slot is empty.
    std::uint32_t add(const TextureUse& use, bool srgb) {
        if (!hasImage(scene_, use)) return kNone;
        const TextureImage& image = scene_.images[static_cast<std::size_t>(use.image)];
        TextureRecord record{};
        record.texels = placeImage(static_cast<std::size_t>(use.image));
        record.size = image.width | image.height << 16U;
        record.flags = (srgb ? kTextureSrgb : 0) | (use.nearest ? kTextureNearest : 0) |
                       (use.uvSet == 1 ? kTextureUv1 : 0) | wrapBits(use.wrapS) << kTextureWrapSShift |
                       wrapBits(use.wrapT) << kTextureWrapTShift;
        record.rowU = glm::vec4(use.rowU, 0);
        record.rowV = glm::vec4(use.rowV, 0);
        arrays_.textures.push_back(record);
        return static_cast<std::uint32_t>(arrays_.textures.size() - 1);
    }

    void copyTexels() {
        arrays_.texels.resize((next_ + 3) / 4 * 4);  // whole words
        tbb::parallel_for(std::size_t{0}, scene_.images.size(), [&](std::size_t i) {
            const std::vector<std::uint32_t>& texels = scene_.images[i].texels;
            if (firstTexel_[i] != kNone)
                std::copy(texels.begin(), texels.end(), arrays_.texels.begin() + firstTexel_[i]);
        });
    }

private:
    std::uint32_t placeImage(std::size_t i) {
        if (firstTexel_[i] != kNone) return firstTexel_[i];
        const TextureImage& image = scene_.images[i];
        if (image.width > 0xffff || image.height > 0xffff || next_ + image.texels.size() >= kNone) {
            throw FileError(scene_.path.string(), "image '" + image.name +
                                                      "': too large; give one of at most "
                                                      "65535 pixels a side, and fewer than 2^32 pixels in all");
        }
        firstTexel_[i] = static_cast<std::uint32_t>(next_);
        next_ += image.texels.size();
        return firstTexel_[i];
    }

    const Scene& scene_;
    SceneArrays& arrays_;
    std::vector<std::uint32_t> firstTexel_;
    std::uint64_t next_ = 0;
};

/// Slots that cannot change the picture are left empty: they would only cost loads.
MaterialRecord materialRecord(const Material& material, const MaterialTraits& traits, TextureLayout& layout) {
    MaterialRecord record{};
    record.baseColor = material.baseColor;
    record.metallic = std::clamp(material.metallic, 0.0F, 1.0F);
    record.roughness = std::clamp(material.roughness, 0.0F, 1.0F);
    record.normalScale = material.normalScale;
    record.alphaCutoff = material.alphaCutoff;
    record.flags = materialFlags(material, traits);
    record.baseColorTexture = record.metallicRoughnessTexture = record.normalTexture = record.emissiveTexture = kNone;
    if (!traits.used) return record;
    record.baseColorTexture = layout.add(material.baseColorTexture, true);
    if (material.unlit) return record;
    if (record.metallic > 0 || record.roughness > 0) {
        record.metallicRoughnessTexture = layout.add(material.metallicRoughnessTexture, false);
    }
    record.normalTexture = layout.add(material.normalTexture, false);
    if (traits.emissive) {
        record.emissive = material.emissive;
        record.emissiveTexture = layout.add(material.emissiveTexture, true);
    }
    return record;
}

}  // namespace

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

void flattenMaterials(const Scene& scene, const std::vector<MaterialTraits>& traits, SceneArrays& arrays) {
    TextureLayout layout(scene, arrays);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const MaterialRecord record = materialRecord(scene.materials[i], traits[i], layout);
        arrays.features.normalMaps |= record.normalTexture != kNone;
        arrays.features.unlit |= traits[i].used && scene.materials[i].unlit;
        arrays.materials.push_back(record);
        arrays.materialNames.push_back(scene.materials[i].name);
    }
    layout.copyTexels();
    arrays.features.textures = !arrays.textures.empty();
    arrays.features.textureTransforms = std::ranges::any_of(arrays.textures, [](const TextureRecord& t) {
        return t.rowU != glm::vec4(1, 0, 0, 0) || t.rowV != glm::vec4(0, 1, 0, 0);
    });
}

}  // namespace vkpt
