// A plain float image in memory.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vkpt {

/// Interleaved float pixels, row 0 at the top, Rec. 709 where they are colours.
struct Image {
    std::uint32_t width = 0, height = 0, channels = 0;
    bool displayEncoded = false;  ///< values are sRGB-encoded, as in PNG files; else linear
    std::vector<float> pixels;

    Image() = default;
    Image(std::uint32_t w, std::uint32_t h, std::uint32_t c)
        : width(w), height(h), channels(c), pixels(std::size_t{w} * h * c) {}
    [[nodiscard]] float* at(std::uint32_t x, std::uint32_t y) {
        return pixels.data() + (std::size_t{y} * width + x) * channels;
    }
    [[nodiscard]] const float* at(std::uint32_t x, std::uint32_t y) const {
        return pixels.data() + (std::size_t{y} * width + x) * channels;
    }
};

}  // namespace vkpt
