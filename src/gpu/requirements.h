// Everything vkpt needs of a Vulkan device, in one place. README repeats it.
//
// Vulkan 1.2 core; no optional feature, no extension. Subgroup ballot and arithmetic are used where they are there.
#pragma once
#include <string>

#include "gpu/device_info.h"

namespace vkpt {

inline constexpr std::uint32_t kRequiredApiVersion = VK_API_VERSION_1_2;
inline constexpr std::uint32_t kRequiredStorageBuffers = 4;         ///< of one kernel: Vulkan's own minimum
inline constexpr std::uint32_t kRequiredWorkGroupInvocations = 64;  ///< Vulkan guarantees 128

/// Empty where `device` meets the requirements, else the first one it misses.
[[nodiscard]] std::string unmetRequirement(const DeviceInfo& device);

}  // namespace vkpt
