// Cuts a render into passes (a range of samples over the whole film) and passes into batches that fit the slots.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace vkpt {

/// Rows of the film that are bound at once.
struct Band {
    std::uint32_t firstPixel = 0, pixelCount = 0;
};

/// Bands of whole rows of at most `maxPixels` pixels (at least one row each).
[[nodiscard]] inline std::vector<Band> makeBands(std::uint32_t width, std::uint32_t height, std::uint64_t maxPixels) {
    const auto rows = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(maxPixels / width, 1, height));
    std::vector<Band> bands;
    for (std::uint32_t y = 0; y < height; y += rows) bands.push_back({y * width, std::min(rows, height - y) * width});
    return bands;
}

/// Samples of the next pass: as many as fill the slots when the film is small. On a larger film the first pass takes
/// one, so that a picture is there soon; later ones several, since the samples of a pixel run well side by side, but few
/// enough that a pass, after which a render can be stopped, takes seconds at most. Bounded, since the accumulate kernel
/// loops over them and lavapipe ends a kernel's loops after 65,535 iterations in all.
[[nodiscard]] inline std::uint32_t samplesPerPass(std::uint64_t pixels, std::uint32_t slots, std::uint32_t done,
                                                  std::uint32_t remaining) {
    constexpr std::uint64_t kMostSamples = 4096, kSideBySide = 16, kMostPaths = 1U << 22;
    pixels = std::max<std::uint64_t>(pixels, 1);
    const std::uint64_t filling = std::clamp<std::uint64_t>(slots / pixels, 1, kMostSamples);
    const std::uint64_t several = done == 0 ? 1 : std::min(kMostPaths / pixels, kSideBySide);
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(std::max(filling, several), remaining));
}

}  // namespace vkpt
