#include "base/image_read.h"

#include <string_view>

#include "base/error.h"
#include "base/file_bytes.h"
#include "base/image_formats.h"

namespace vkpt {
Image readImage(const std::filesystem::path& file) { return decodeImage(file.string(), readFileBytes(file)); }

Image decodeImage(const std::string& name, std::span<const std::uint8_t> bytes) {
    const std::string_view start(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (start.starts_with("#?")) return decodeHdr(name, bytes);
    if (start.starts_with("\x76\x2f\x31\x01")) return decodeExr(name, bytes);
    if (start.starts_with("\x89PNG\r\n\x1a\n")) return decodePng(name, bytes);
    if (start.starts_with("PF") || start.starts_with("Pf")) return decodePfm(name, bytes);
    throw FileError(name, "is no image vkpt reads; give .hdr, .exr, .pfm or .png");
}

}  // namespace vkpt
