// PNG files in memory to samples, by libspng.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vkpt {

/// RGBA, row 0 at the top; 8 or 16 bits a sample, as the file has it. Values are as stored: no gamma, no colour
/// profile.
struct PngPixels {
    std::uint32_t width = 0, height = 0;
    bool alpha = false;  ///< the file has transparency of any kind
    std::vector<std::uint8_t> rgba8;
    std::vector<std::uint16_t> rgba16;  ///< one of the two is empty
};

/// Larger images are refused.
inline constexpr std::uint64_t kMostPngPixels = std::uint64_t{1} << 28U;

/// Grey and palette images become RGB. On failure `fault` says why and the result has no pixels. Memory grows with
/// what the file proves to hold.
[[nodiscard]] PngPixels decodePng(std::span<const std::uint8_t> bytes, std::string& fault);

}  // namespace vkpt
