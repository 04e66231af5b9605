// Images as the bytes of a file. Nothing here touches the disk.
#pragma once
#include <cstddef>
#include <cstdint>
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

/// One channel of an EXR part. The values are somebody else's and must outlive the encoding.
struct ExrChannel {
    enum class Type : std::uint8_t { Float, Uint };

    std::string name;
    Type type = Type::Float;
    const void* first = nullptr;  ///< of the upper left pixel
    std::size_t pixelStride = 0;  ///< bytes to the next pixel; rows follow each other
};

/// One part: an image of its own with a name.
struct ExrPart {
    std::string name;
    ImageMetadata metadata;  ///< string attributes
    std::vector<ExrChannel> channels;
};

/// OpenEXR, ZIP, one part or several of the same size; a single one is a plain file, readable by anything. Works on
/// all threads that TBB may use.
[[nodiscard]] Bytes encodeExr(std::uint32_t width, std::uint32_t height, const std::vector<ExrPart>& parts);

/// The channels of an image, by names in their order.
[[nodiscard]] std::vector<ExrChannel> channelsOf(const Image& image, const std::vector<std::string>& names);

/// A single part of linear values, 3 or 4 channels (premultiplied alpha), 32-bit float.
[[nodiscard]] Bytes encodeExr(const Image& linear, const ImageMetadata& metadata);

/// Radiance RGBE of the first three channels; what is below 0 becomes 0.
[[nodiscard]] Bytes encodeHdr(const Image& linear);

/// Portable float map of the first three channels: little endian, bottom row first.
[[nodiscard]] Bytes encodePfm(const Image& linear);

}  // namespace vkpt
