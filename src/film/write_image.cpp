#include "film/write_image.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>

#include "base/atomic_file.h"
#include "base/error.h"

namespace vkpt {

std::optional<ImageFormat> imageFormat(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") return ImageFormat::Png;
    if (extension == ".exr") return ImageFormat::Exr;
    if (extension == ".hdr") return ImageFormat::Hdr;
    if (extension == ".pfm") return ImageFormat::Pfm;
    return std::nullopt;
}

void writeImage(const std::filesystem::path& path, const Image& linear, const WriteOptions& options,
                const ImageMetadata& metadata) {
    const std::optional<ImageFormat> format = imageFormat(path);
    if (!format)
        throw FileError(path.string(),
                        fmt::format("no image format has this extension, use one of {}", kImageExtensions));
    Bytes bytes;
    switch (*format) {
        case ImageFormat::Png:
            bytes = encodePng(displayImage(linear, options.display), options.pngBits, metadata);
            break;
        case ImageFormat::Exr:
            bytes = encodeExr(linear, metadata);
            break;
        case ImageFormat::Hdr:
            bytes = encodeHdr(linear);
            break;
        case ImageFormat::Pfm:
            bytes = encodePfm(linear);
            break;
    }
    writeFileAtomically(path, bytes);
}

}  // namespace vkpt
