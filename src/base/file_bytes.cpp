#include "base/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/error.h"

namespace vkpt {

std::vector<std::uint8_t> readFileBytes(const std::filesystem::path& file) {
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

}  // namespace vkpt
