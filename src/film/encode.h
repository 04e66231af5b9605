// Images as the bytes of a file. Nothing here touches the disk.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/image.h"

namespace vkpt {

using Bytes = std::vector<std::byte>;

/// What a render was made from: key and value, in the order they are stored.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// PNG of display values in [0, 1], 3 or 4 channels (straight alpha), 8 or 16 bits a channel, rounded to nearest.
/// Files carry `metadata` as text chunks and are tagged sRGB.
/// Throws Error where the encoder refuses.
[[nodiscard]] Bytes encodePng(const Image& display, int bits, const ImageMetadata& metadata);

/// OpenEXR of linear values, 3 or 4 channels (premultiplied alpha), 32-bit float, ZIP; metadata as string
/// attributes.
[[nodiscard]] Bytes encodeExr(const Image& linear, const ImageMetadata& metadata);

/// Radiance RGBE of the first three channels.
[[nodiscard]] Bytes encodeHdr(const Image& linear);

/// Portable float map of the first three channels: little endian, bottom row first.
[[nodiscard]] Bytes encodePfm(const Image& linear);

}  // namespace vkpt
