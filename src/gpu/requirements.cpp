#include "gpu/requirements.h"

#include <fmt/format.h>

namespace vkpt {

std::string unmetRequirement(const DeviceInfo& device) {
    if (device.apiVersion < kRequiredApiVersion)
        return fmt::format("it offers Vulkan {}; {} is needed", versionText(device.apiVersion),
                           versionText(kRequiredApiVersion));
    const auto lacks = [](std::uint32_t has, std::uint32_t needs, std::string_view what) {
        return has < needs ? fmt::format("{} {}; {} are needed", has, what, needs) : std::string();
    };
    std::string fault =
        lacks(device.limits.maxPerStageDescriptorStorageBuffers, kRequiredStorageBuffers, "storage buffers a kernel");
    if (fault.empty())
        fault = lacks(device.limits.maxComputeWorkGroupInvocations, kRequiredWorkGroupInvocations,
                      "invocations a work group");
    return fault;
}

}  // namespace vkpt
