#include "base/hash.h"

#include <fmt/format.h>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "base/error.h"

namespace vkpt {

ContentHash& ContentHash::add(std::span<const std::byte> bytes) {
    for (const std::byte b : bytes) state_ = (state_ ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
    return *this;
}

ContentHash& ContentHash::add(std::string_view text) {
    add(std::as_bytes(std::span(text)));
    constexpr std::byte end{0};
    return add(std::span(&end, 1));
}

ContentHash& ContentHash::addFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path.string(), fmt::format("cannot open: {}", std::strerror(errno)));
    std::vector<char> block(1U << 16U);
    while (file) {
        file.read(block.data(), static_cast<std::streamsize>(block.size()));
        add(std::as_bytes(std::span(block.data(), static_cast<std::size_t>(file.gcount()))));
    }
    if (file.bad()) throw FileError(path.string(), fmt::format("cannot read: {}", std::strerror(errno)));
    return *this;
}

std::string ContentHash::hex() const { return fmt::format("{:016x}", state_); }

}  // namespace vkpt
