// One decoder a file format, behind readImage. `name` is what errors call the file.
#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "base/image.h"

namespace vkpt {

inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28U;

[[nodiscard]] Image decodeHdr(const std::string& name, std::span<const std::uint8_t> bytes);
[[nodiscard]] Image decodeExr(const std::string& name, std::span<const std::uint8_t> bytes);
[[nodiscard]] Image decodePfm(const std::string& name, std::span<const std::uint8_t> bytes);
[[nodiscard]] Image decodePng(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace vkpt
