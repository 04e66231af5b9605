// Vulkan calls that fail on demand, and a count of the objects that are alive.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace vkpt {

/// What is to fail, and what happened. Between calls of `interceptVulkan` and the end of the process every Vulkan call
/// of vkpt that can fail comes by here.
struct VulkanFaults {
    enum class Kind {
        Allocation,  ///< of memory or an object, or a call that may run out of memory
        Submission,  ///< a submission or the wait for it: fails as a lost device does
    };

    Kind kind = Kind::Allocation;
    std::uint32_t failAt = 0;  ///< which call of the kind fails, from 1; 0: none

    std::vector<std::string> calls;    ///< names of those of the kind, so far
    std::string failed;                ///< name of the call that failed
    bool lost = false;                 ///< a lost device stays lost
    std::map<std::string, int> alive;  ///< by the name of what made them: made and not yet destroyed
};

[[nodiscard]] VulkanFaults& vulkanFaults();

/// Puts wrappers before the functions that vkpt calls, for every instance made from now on.
void interceptVulkan();

}  // namespace vkpt
