// Small scenes made in memory.
#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/flatten.h"
#include "scene/render_options.h"
#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// A parallelogram of two triangles, front side cross(u, v), texture coordinates (0,0) at `corner`.
[[nodiscard]] Primitive makeQuad(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v,
                                 std::uint32_t material);

/// A curved sheet of 2 n^2 triangles over [-1,1]^2 with bent normals, tangents of either handedness, both sets of
/// texture coordinates and vertex colours.
[[nodiscard]] Primitive makePatch(std::uint32_t n, std::uint32_t material);

/// RGBA noise.
[[nodiscard]] TextureImage makeNoise(std::uint32_t width, std::uint32_t height, std::uint32_t seed);

/// A mesh of its own for one primitive, placed once for each matrix.
void addObject(Scene& scene, Primitive primitive, const std::vector<glm::mat4>& placements = {glm::mat4(1)});

/// A plain material.
[[nodiscard]] Material makeMaterial(const glm::vec3& base, float metallic, float roughness);

/// Rotation about an axis (degrees), then a scale along the axes before it, then a translation after it.
[[nodiscard]] glm::mat4 makeTransform(const glm::vec3& translation, float degrees, const glm::vec3& axis,
                                      const glm::vec3& scale);

/// flatten and buildBvh.
[[nodiscard]] SceneArrays makeArrays(const Scene& scene, const FlattenOptions& options = {});

/// Lights a scene by 8 x 4 texels of noise, turned by 30 degrees, and builds its BVH.
void finishUnderNoise(SceneArrays& arrays, std::uint32_t seed);

/// A floor under every kind of light: emissive triangles of one side, of two sides, with a texture, a point light
/// without and one with a range, a spot light, a directional light. No environment.
[[nodiscard]] Scene makeLamps();

/// Patches with a normal map, textures of both sets and vertex colours, placed by matrices that scale unevenly, rotate
/// and mirror.
[[nodiscard]] Scene makePatches();

/// Patches among alpha of all sorts: MASK and BLEND, by factor, texture and vertex colour, single- and double-sided.
[[nodiscard]] Scene makeFoliage();

/// Lamps and foliage under a sky: every feature of the kernels but normal maps, and instances where they are asked for.
[[nodiscard]] SceneArrays makeEverything(bool instances = false);

/// A patch of every BSDF model, some of them twice (smooth, rough, anisotropic under a normal map), among the lamps and
/// under a sky. Light passes through the dielectrics.
[[nodiscard]] SceneArrays makeBsdfPatches(bool multiscatter);

/// A camera before the lamps, 5 bounces, roulette after 3; samples [0, samples) of as many.
[[nodiscard]] RenderOptions makeOptions(std::uint32_t width, std::uint32_t height, std::uint32_t samples);

/// A closed white box of 16 m that glows all over: no path ends before its last bounce, unless roulette ends it.
[[nodiscard]] SceneArrays makeFurnace();

/// 2 n^2 triangles over [-3,3]^2 in xz, with shading normals that point up.
[[nodiscard]] Primitive makeHeightfield(std::uint32_t n);

}  // namespace vkpt
