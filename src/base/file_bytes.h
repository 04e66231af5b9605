// Whole files in memory.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace vkpt {

/// All bytes of a file. Throws FileError, with the system's reason.
[[nodiscard]] std::vector<std::uint8_t> readFileBytes(const std::filesystem::path& file);

}  // namespace vkpt
