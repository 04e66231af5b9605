// What a surface is made of at one point.
#pragma once
#include "reference/bsdf.h"
#include "reference/hash.h"
#include "reference/hit.h"
#include "reference/sampler.h"
#include "reference/texture.h"

namespace vkpt::reference {

/// Vertex attributes at a hit that materials read.
struct Attributes {
    TexCoords coords;
    glm::vec4 color{1};  ///< COLOR_0; 1 where the scene has none
};

[[nodiscard]] Attributes interpolateAttributes(const SceneArrays& scene, const TriangleRecord& triangle,
                                               const glm::vec3& barycentrics);

[[nodiscard]] inline const MaterialRecord& materialOf(const SceneArrays& scene, const TriangleRecord& triangle) {
    return scene.materials[triangle.flags >> kTriangleMaterialShift];
}

/// Factor x texture x vertex colour, alpha included.
[[nodiscard]] glm::vec4 baseColor(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at);

/// Factor x texture in nits, whichever side is seen.
[[nodiscard]] glm::vec3 emission(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at);

/// (metallic, perceptual roughness): factors x texture.
[[nodiscard]] glm::vec2 metallicRoughness(const SceneArrays& scene, const MaterialRecord& material,
                                          const Attributes& at);

/// Texture x vertex colour, without the factor: what multiplies the colour of models other than glTF's.
[[nodiscard]] glm::vec3 colorMap(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at);
/// The texture of the roughness alone.
[[nodiscard]] float roughnessMap(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at);

[[nodiscard]] inline BsdfId modelOf(const MaterialRecord& material) {
    return static_cast<BsdfId>((material.flags >> kMaterialModelShift) & kMaterialModelMask);
}

/// The BSDF of a point whose wo is on the front, or on the back, of the surface.
[[nodiscard]] Bsdf<float> bsdfOf(const SceneArrays& scene, const TriangleRecord& triangle, const Attributes& at,
                                 bool front);

/// Key of the stochastic alpha test of segment `bounce`; `kind` is kRayPath or kRayShadow.
[[nodiscard]] inline std::uint32_t alphaKey(const SampleId& id, std::uint32_t bounce, std::uint32_t kind) {
    return hash({id.pixel, id.index, id.seed, 2 * bounce + kind}).x;
}

/// The alpha test of a triangle with kTriangleHasAlpha. A function of its arguments alone: the order in which a
/// traversal meets triangles changes nothing.
[[nodiscard]] bool isPresent(const SceneArrays& scene, const Hit& hit, std::uint32_t alphaKey);

}  // namespace vkpt::reference
