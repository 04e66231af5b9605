// How much memory there is.
#pragma once
#include <cstdint>

namespace vkpt {

/// Bytes of main memory that this process may have: the machine's, or less where a control group limits it.
[[nodiscard]] std::uint64_t physicalMemory();

}  // namespace vkpt
