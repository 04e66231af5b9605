// Textures fetched, decoded and filtered in plain code. estimator.md, Textures.
#pragma once
#include "scene/scene_arrays.h"

namespace vkpt::reference {

/// Coordinates of one surface point in both sets.
struct TexCoords {
    glm::vec2 uv0{0}, uv1{0};
};

/// Inverse of the sRGB transfer function, exact piecewise form, of byte / 255. [IEC 61966-2-1]
[[nodiscard]] float decodeSrgb(std::uint32_t byte);

/// The texel index that `index` wraps to on an axis of `size` texels; `wrap` is a kWrap* constant.
[[nodiscard]] std::uint32_t wrapTexel(std::int64_t index, std::uint32_t size, std::uint32_t wrap);

/// RGBA of a TextureRecord at a surface point; colour decoded to linear before filtering.
[[nodiscard]] glm::vec4 sampleTexture(const SceneArrays& scene, std::uint32_t texture, const TexCoords& coords);

}  // namespace vkpt::reference
