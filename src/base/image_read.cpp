#include "base/image_read.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "base/image_formats.h"

namespace vkpt {
namespace {

std::vector<std::uint8_t> readBytes(const std::filesystem::path& file) {
    std::error_code status;
    if (std::filesystem::is_directory(file, status)) throw FileError(file.string(), "is a folder, not an image");
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    if (!stream) throw FileError(file.string(), std::string("cannot be opened: ") + std::strerror(errno));
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0)));
    stream.seekg(0);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream) throw FileError(file.string(), "cannot be read to its end");
    return bytes;
}

}  // namespace

Image readImage(const std::filesystem::path& file) { return decodeImage(file.string(), readBytes(file)); }

Image decodeImage(const std::string& name, std::span<const std::uint8_t> bytes) {
    const std::string_view start(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (start.starts_with("#?")) return decodeHdr(name, bytes);
    if (start.starts_with("\x76\x2f\x31\x01")) return decodeExr(name, bytes);
    if (start.starts_with("\x89PNG\r\n\x1a\n")) return decodePng(name, bytes);
    if (start.starts_with("PF") || start.starts_with("Pf")) return decodePfm(name, bytes);
    throw FileError(name, "is no image vkpt reads; give .hdr, .exr, .pfm or .png");
}

}  // namespace vkpt
