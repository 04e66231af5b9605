// What a Vulkan device is and whether vkpt runs there.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace vkpt {

/// The limits of one device that decide how vkpt works on it. Sizes in bytes.
struct DeviceLimits {
    std::uint64_t maxStorageBufferRange = 0;
    std::uint64_t maxTexelBufferElements = 0;
    std::uint64_t maxUniformBufferRange = 0;
    std::uint64_t maxMemoryAllocationSize = 0;
    std::uint32_t maxPerStageDescriptorStorageBuffers = 0;
    std::uint32_t maxPushConstantsSize = 0;
    std::uint32_t maxComputeWorkGroupCount = 0;  ///< along x
    std::uint32_t maxComputeWorkGroupSize = 0;   ///< along x
    std::uint32_t maxComputeWorkGroupInvocations = 0;
    std::uint32_t maxComputeSharedMemorySize = 0;
    std::uint32_t minStorageBufferOffsetAlignment = 1;
    std::uint32_t minUniformBufferOffsetAlignment = 1;
    std::uint32_t minTexelBufferOffsetAlignment = 1;
};

/// One physical device as `vkpt devices` shows it.
struct DeviceInfo {
    std::uint32_t index = 0;  ///< what --device takes
    std::string name, type;   ///< type: "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;       ///< driver's name and version
    std::uint32_t apiVersion = 0;
    bool isCpu = false;
    std::uint32_t subgroupSize = 0;
    bool subgroupBallot = false, subgroupArithmetic = false;  ///< usable in compute shaders
    bool timestamps = false;
    double timestampPeriod = 0;     ///< seconds a tick
    std::uint64_t heapBytes = 0;    ///< the largest device-local heap
    std::uint32_t queueFamily = 0;  ///< the one vkpt computes on
    DeviceLimits limits;
    std::string unusable;  ///< empty where vkpt runs, else why not
};

/// "1.3.230"
[[nodiscard]] std::string versionText(std::uint32_t apiVersion);

/// Reads everything above from a device.
[[nodiscard]] DeviceInfo describeDevice(VkPhysicalDevice device, std::uint32_t index);

/// All devices of the Vulkan loader, in its order. Throws DeviceError, naming the package to install, where there is
/// no loader or no driver. Does not create a device.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

/// Picks a device: by `select` (an index, or a part of a name, case ignored), or where it is empty the first usable
/// one of the best type (discrete, integrated, virtual, other, CPU). Throws DeviceError where none fits.
[[nodiscard]] std::uint32_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& select);

}  // namespace vkpt
