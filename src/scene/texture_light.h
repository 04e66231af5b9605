// How bright an emissive texture is over a triangle: only a weight for choosing lights, so an estimate will do.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene_arrays.h"

namespace vkpt {

/// Luminance of texture x factor, prepared once for many triangles: large textures are first averaged over blocks.
class EmissiveTexture {
public:
    EmissiveTexture(const SceneArrays& arrays, const TextureRecord& texture, const glm::vec3& factor);

    /// Mean over the triangle with these texture coordinates, by point samples about a block apart (16 to 4,096 of
    /// them). 0 where all samples and their bilinear neighbours are black.
    [[nodiscard]] float mean(const std::array<glm::vec2, 3>& uv) const;

private:
    [[nodiscard]] float block(std::int64_t x, std::int64_t y) const;
    [[nodiscard]] float at(const glm::vec2& p) const;

    TextureRecord texture_;
    std::int64_t width_, height_;   // in blocks
    std::vector<float> luminance_;  // a value a block, row by row
};

}  // namespace vkpt
