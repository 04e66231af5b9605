// A rendered image to a file; the extension chooses the format.
#pragma once
#include <filesystem>
#include <optional>
#include <string_view>

#include "base/image.h"
#include "film/encode.h"
#include "film/tonemap.h"

namespace vkpt {

enum class ImageFormat : std::uint8_t { Png, Exr, Hdr, Pfm };

inline constexpr std::string_view kImageExtensions = ".png .exr .hdr .pfm";

/// By extension, whatever its case; empty where it is none of kImageExtensions.
[[nodiscard]] std::optional<ImageFormat> imageFormat(const std::filesystem::path& path);

struct WriteOptions {
    Display display;  ///< PNG only: the other formats hold linear radiance
    int pngBits = 8;  ///< 8 or 16
};

/// Writes linear premultiplied RGBA. The file appears whole or not at all: an older one is untouched on failure.
/// Throws FileError.
void writeImage(const std::filesystem::path& path, const Image& linear, const WriteOptions& options,
                const ImageMetadata& metadata);

}  // namespace vkpt
