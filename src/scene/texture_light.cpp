#include "scene/texture_light.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/math.h"

namespace vkpt {
namespace {

constexpr int kLeastSteps = 4, kMostSteps = 64;  // a triangle is cut into steps^2 equal ones

const std::array<float, 256>& srgbTable() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = srgbToLinear(static_cast<float>(i) / 255.0F);
        return t;
    }();
    return table;
}

std::int64_t wrap(std::int64_t i, std::int64_t n, std::uint32_t mode) {
    if (mode == kWrapClamp) return std::clamp<std::int64_t>(i, 0, n - 1);
    const std::int64_t period = mode == kWrapMirror ? 2 * n : n;
    i = (i % period + period) % period;
    return i < n ? i : period - 1 - i;
}

/// Texels along one side of a block: large textures need no more detail to weigh lights.
std::int64_t blockSize(std::int64_t width, std::int64_t height) {
    constexpr std::int64_t kLeastBlocks = 256;
    std::int64_t size = 1;
    while (width % (2 * size) == 0 && height % (2 * size) == 0 && std::min(width, height) / (2 * size) >= kLeastBlocks)
        size *= 2;
    return size;
}

}  // namespace

EmissiveTexture::EmissiveTexture(const SceneArrays& arrays, const TextureRecord& texture, const glm::vec3& factor)
    : texture_(texture) {
    const std::int64_t width = texture.size & 0xffffU, height = texture.size >> 16U, size = blockSize(width, height);
    width_ = width / size;
    height_ = height / size;
    luminance_.resize(static_cast<std::size_t>(width_ * height_));
    const auto& decode = srgbTable();
    tbb::parallel_for(std::int64_t{0}, height_, [&](std::int64_t row) {
        float* out = luminance_.data() + row * width_;
        for (std::int64_t y = row * size; y < (row + 1) * size; ++y) {
            const std::uint32_t* in = arrays.texels.data() + texture.texels + y * width * texture.stride;
            for (std::int64_t x = 0; x < width; ++x, in += texture.stride)
                out[x / size] += luminance(
                    factor * glm::vec3(decode[*in & 255U], decode[*in >> 8U & 255U], decode[*in >> 16U & 255U]));
        }
        for (std::int64_t x = 0; x < width_; ++x) out[x] /= static_cast<float>(size * size);
    });
}

float EmissiveTexture::block(std::int64_t x, std::int64_t y) const {
    const std::int64_t i = wrap(x, width_, texture_.flags >> kTextureWrapSShift & kTextureWrapMask);
    const std::int64_t j = wrap(y, height_, texture_.flags >> kTextureWrapTShift & kTextureWrapMask);
    return luminance_[static_cast<std::size_t>(j * width_ + i)];
}

/// At a position in blocks, where block i covers [i, i+1).
float EmissiveTexture::at(const glm::vec2& p) const {
    if ((texture_.flags & kTextureNearest) != 0)
        return block(static_cast<std::int64_t>(std::floor(p.x)), static_cast<std::int64_t>(std::floor(p.y)));
    const glm::vec2 base = glm::floor(p - 0.5F), f = p - 0.5F - base;
    const auto x = static_cast<std::int64_t>(base.x), y = static_cast<std::int64_t>(base.y);
    return glm::mix(glm::mix(block(x, y), block(x + 1, y), f.x), glm::mix(block(x, y + 1), block(x + 1, y + 1), f.x),
                    f.y);
}

float EmissiveTexture::mean(const std::array<glm::vec2, 3>& uv) const {
    std::array<glm::vec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 v(uv[i], 1);
        p[i] = glm::vec2(glm::dot(glm::vec3(texture_.rowU), v) * static_cast<float>(width_),
                         glm::dot(glm::vec3(texture_.rowV), v) * static_cast<float>(height_));
        if (!(std::abs(p[i].x) < 1e9F && std::abs(p[i].y) < 1e9F)) return 0;
    }
    const float extent = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    const int steps = static_cast<int>(std::clamp(extent, float{kLeastSteps}, float{kMostSteps}));
    const glm::vec2 du = (p[1] - p[0]) / static_cast<float>(steps), dv = (p[2] - p[0]) / static_cast<float>(steps);

    // The centroids of steps^2 congruent triangles: upright ones at a third, inverted ones at two thirds.
    double sum = 0;
    for (int j = 0; j < steps; ++j) {
        for (int i = 0; i + j < steps; ++i) {
            const glm::vec2 corner = p[0] + static_cast<float>(i) * du + static_cast<float>(j) * dv;
            sum += at(corner + (du + dv) / 3.0F);
            if (i + j + 1 < steps) sum += at(corner + (du + dv) * (2.0F / 3.0F));
        }
    }
    return static_cast<float>(sum / (static_cast<double>(steps) * steps));
}

}  // namespace vkpt
