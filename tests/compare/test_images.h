// Images that the tests of comparisons share.
#pragma once
#include <cstdint>
#include <limits>
#include <random>

#include "base/image.h"

namespace vkpt {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Independent uniform values in [0, largest).
[[nodiscard]] inline Image noise(std::uint32_t width, std::uint32_t height, std::uint32_t channels, unsigned seed,
                                 float largest = 1) {
    Image image(width, height, channels);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> value(0, largest);
    for (float& v : image.pixels) v = value(generator);
    return image;
}

}  // namespace vkpt
