// A hash of content that is the same on every machine and in every version.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vkpt {

/// FNV-1a, 64 bits. [Fowler 91] Tells apart by accident, not by malice.
class ContentHash {
public:
    ContentHash& add(std::span<const std::byte> bytes);
    /// The text and its end: "ab","c" and "a","bc" differ.
    ContentHash& add(std::string_view text);
    /// The bytes of a file. Throws FileError.
    ContentHash& addFile(const std::filesystem::path& path);

    [[nodiscard]] std::uint64_t value() const { return state_; }
    /// 16 hexadecimal digits.
    [[nodiscard]] std::string hex() const;

private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

}  // namespace vkpt
