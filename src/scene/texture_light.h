// How bright an emissive texture is over a triangle: only a weight for choosing lights, so an estimate will do.
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "scene/scene_arrays.h"

namespace vkpt {

/// Mean of luminance(texture x factor) over the triangle with these texture coordinates, by point samples about a
/// texel apart (16 to 4,096 of them). 0 where all samples and their bilinear neighbours are black.
[[nodiscard]] float meanEmission(const SceneArrays& arrays, const TextureRecord& texture, const glm::vec3& factor,
                                 const std::array<glm::vec2, 3>& uv);

}  // namespace vkpt
