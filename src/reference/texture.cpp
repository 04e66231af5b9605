#include "reference/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vkpt::reference {

namespace {

const std::array<float, 256> kSrgbTable = [] {
    std::array<float, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) table[i] = decodeSrgb(i);
    return table;
}();

/// floor(x) as an integer; coordinates beyond any texture's reach (and NaN) are brought into range first.
std::int64_t floorIndex(float x) {
    constexpr float kReach = 1e15F;
    return static_cast<std::int64_t>(std::floor(std::isnan(x) ? 0.0F : std::clamp(x, -kReach, kReach)));
}

class TexelGrid {
public:
    TexelGrid(const SceneArrays& scene, const TextureRecord& texture)
        : texels_(scene.texels.data() + texture.texels),
          stride_(texture.stride),
          width_(texture.size & 0xffffU),
          height_(texture.size >> 16U),
          wrapS_((texture.flags >> kTextureWrapSShift) & kTextureWrapMask),
          wrapT_((texture.flags >> kTextureWrapTShift) & kTextureWrapMask),
          srgb_((texture.flags & kTextureSrgb) != 0) {}

    [[nodiscard]] glm::vec2 size() const { return {width_, height_}; }

    [[nodiscard]] glm::vec4 at(std::int64_t x, std::int64_t y) const {
        const std::size_t row = wrapTexel(y, height_, wrapT_);
        const std::uint32_t word = texels_[(row * width_ + wrapTexel(x, width_, wrapS_)) * stride_];
        const auto byte = [word](std::uint32_t channel) { return (word >> (8 * channel)) & 0xffU; };
        const auto linear = [&](std::uint32_t channel) {
            return srgb_ ? kSrgbTable[byte(channel)] : static_cast<float>(byte(channel)) / 255.0F;
        };
        return {linear(0), linear(1), linear(2), static_cast<float>(byte(3)) / 255.0F};
    }

private:
    const std::uint32_t* texels_;
    std::size_t stride_;
    std::uint32_t width_, height_, wrapS_, wrapT_;
    bool srgb_;
};

}  // namespace

float decodeSrgb(std::uint32_t byte) {
    const double c = byte / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
}

std::uint32_t wrapTexel(std::int64_t index, std::uint32_t size, std::uint32_t wrap) {
    const std::int64_t n = size;
    const auto modulo = [](std::int64_t a, std::int64_t m) { return ((a % m) + m) % m; };
    if (wrap == kWrapClamp) return static_cast<std::uint32_t>(std::clamp<std::int64_t>(index, 0, n - 1));
    if (wrap == kWrapMirror) {
        const std::int64_t m = modulo(index, 2 * n);
        return static_cast<std::uint32_t>(m < n ? m : 2 * n - 1 - m);
    }
    return static_cast<std::uint32_t>(modulo(index, n));
}

glm::vec4 sampleTexture(const SceneArrays& scene, std::uint32_t texture, const TexCoords& coords) {
    const TextureRecord& record = scene.textures[texture];
    const TexelGrid grid(scene, record);
    const glm::vec3 uv1((record.flags & kTextureUv1) != 0 ? coords.uv1 : coords.uv0, 1.0F);
    const glm::vec2 position =
        glm::vec2(glm::dot(glm::vec3(record.rowU), uv1), glm::dot(glm::vec3(record.rowV), uv1)) * grid.size();
    if ((record.flags & kTextureNearest) != 0) return grid.at(floorIndex(position.x), floorIndex(position.y));
    const glm::vec2 corner = position - 0.5F;
    const glm::vec2 fraction = corner - glm::floor(corner);
    const std::int64_t x = floorIndex(corner.x), y = floorIndex(corner.y);
    const glm::vec4 upper = glm::mix(grid.at(x, y), grid.at(x + 1, y), fraction.x);
    const glm::vec4 lower = glm::mix(grid.at(x, y + 1), grid.at(x + 1, y + 1), fraction.x);
    return glm::mix(upper, lower, fraction.y);
}

}  // namespace vkpt::reference
