#include "gpu/device_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <optional>

#include "base/error.h"
#include "gpu/instance.h"
#include "gpu/requirements.h"

namespace vkpt {

namespace {

std::string typeText(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
            return "discrete GPU";
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
            return "integrated GPU";
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
            return "virtual GPU";
        case VK_PHYSICAL_DEVICE_TYPE_CPU:
            return "CPU";
        default:
            return "other";
    }
}

/// Lower is preferred.
int rank(const DeviceInfo& device) {
    constexpr std::string_view kOrder[] = {"discrete GPU", "integrated GPU", "virtual GPU", "other", "CPU"};
    return static_cast<int>(std::find(std::begin(kOrder), std::end(kOrder), device.type) - std::begin(kOrder));
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

std::string namesOf(const std::vector<DeviceInfo>& devices) {
    std::string text;
    for (const DeviceInfo& device : devices)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", device.index, device.name);
    return text;
}

DeviceLimits readLimits(const VkPhysicalDeviceLimits& from, const VkPhysicalDeviceVulkan11Properties& more) {
    return {.maxStorageBufferRange = from.maxStorageBufferRange,
            .maxTexelBufferElements = from.maxTexelBufferElements,
            .maxUniformBufferRange = from.maxUniformBufferRange,
            .maxMemoryAllocationSize = more.maxMemoryAllocationSize,
            .maxPerStageDescriptorStorageBuffers = from.maxPerStageDescriptorStorageBuffers,
            .maxPushConstantsSize = from.maxPushConstantsSize,
            .maxComputeWorkGroupCount = from.maxComputeWorkGroupCount[0],
            .maxComputeWorkGroupSize = from.maxComputeWorkGroupSize[0],
            .maxComputeWorkGroupInvocations = from.maxComputeWorkGroupInvocations,
            .maxComputeSharedMemorySize = from.maxComputeSharedMemorySize,
            .minStorageBufferOffsetAlignment = static_cast<std::uint32_t>(from.minStorageBufferOffsetAlignment),
            .minUniformBufferOffsetAlignment = static_cast<std::uint32_t>(from.minUniformBufferOffsetAlignment),
            .minTexelBufferOffsetAlignment = static_cast<std::uint32_t>(from.minTexelBufferOffsetAlignment)};
}

/// A queue family that computes: without graphics where there is one, since it does not compete with a desktop.
std::optional<std::uint32_t> computeFamily(const std::vector<VkQueueFamilyProperties>& families) {
    std::optional<std::uint32_t> found;
    for (std::uint32_t i = 0; i < families.size(); ++i) {
        if (!(families[i].queueFlags & VK_QUEUE_COMPUTE_BIT)) continue;
        const bool dedicated = !(families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT);
        if (!found || dedicated) found = i;
        if (dedicated) break;
    }
    return found;
}

void readQueues(VkPhysicalDevice device, const VkPhysicalDeviceLimits& limits, DeviceInfo& info) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    const auto family = computeFamily(families);
    if (!family) {
        info.unusable = "no compute queue";
        return;
    }
    info.queueFamily = *family;
    // Wrap-around of a counter of fewer than 36 bits would come within a minute at 1 ns a tick.
    info.timestamps = families[*family].timestampValidBits >= 36 && limits.timestampPeriod > 0;
    info.timestampPeriod = static_cast<double>(limits.timestampPeriod) * 1e-9;
}

std::uint64_t largestLocalHeap(VkPhysicalDevice device) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(device, &memory);
    std::uint64_t largest = 0;
    for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
            largest = std::max<std::uint64_t>(largest, memory.memoryHeaps[i].size);
    return largest;
}

}  // namespace

std::string versionText(std::uint32_t apiVersion) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(apiVersion), VK_API_VERSION_MINOR(apiVersion),
                       VK_API_VERSION_PATCH(apiVersion));
}

DeviceInfo describeDevice(VkPhysicalDevice device, std::uint32_t index) {
    VkPhysicalDeviceProperties basic;
    vkGetPhysicalDeviceProperties(device, &basic);
    DeviceInfo info;
    info.index = index;
    info.name = basic.deviceName;
    info.type = typeText(basic.deviceType);
    info.isCpu = basic.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    info.apiVersion = basic.apiVersion;
    if (basic.apiVersion < kRequiredApiVersion) {  // the queries below are those of Vulkan 1.2
        info.unusable = fmt::format("it offers Vulkan {}; {} is needed", versionText(basic.apiVersion),
                                    versionText(kRequiredApiVersion));
        return info;
    }
    VkPhysicalDeviceVulkan12Properties v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES;
    VkPhysicalDeviceVulkan11Properties v11{};
    v11.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES;
    v11.pNext = &v12;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &v11;
    vkGetPhysicalDeviceProperties2(device, &all);

    info.driver = fmt::format("{} {}", v12.driverName, v12.driverInfo);
    info.subgroupSize = v11.subgroupSize;
    if (v11.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT) {
        info.subgroupBallot = v11.subgroupSupportedOperations & VK_SUBGROUP_FEATURE_BALLOT_BIT;
        info.subgroupArithmetic = v11.subgroupSupportedOperations & VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
    }
    info.limits = readLimits(basic.limits, v11);
    info.heapBytes = largestLocalHeap(device);
    readQueues(device, basic.limits, info);
    if (info.unusable.empty()) info.unusable = unmetRequirement(info);
    return info;
}

std::vector<DeviceInfo> listDevices() { return Instance({}).devices(); }

std::uint32_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& select) {
    const DeviceInfo* chosen = nullptr;
    if (select.empty()) {
        for (const DeviceInfo& device : devices)
            if (device.unusable.empty() && (!chosen || rank(device) < rank(*chosen))) chosen = &device;
        if (!chosen)
            throw DeviceError(
                fmt::format("no usable Vulkan device: {}: {}", devices.front().name, devices.front().unusable));
        return chosen->index;
    }
    const bool isNumber = std::all_of(select.begin(), select.end(), [](unsigned char c) { return std::isdigit(c); });
    for (const DeviceInfo& device : devices) {
        const bool fits = isNumber && select.size() < 4 ? device.index == std::stoul(select)
                                                        : lower(device.name).find(lower(select)) != std::string::npos;
        if (fits && (!chosen || (!chosen->unusable.empty() && device.unusable.empty()))) chosen = &device;
    }
    if (!chosen) throw DeviceError(fmt::format("no Vulkan device is '{}'; there are: {}", select, namesOf(devices)));
    if (!chosen->unusable.empty())
        throw DeviceError(fmt::format("{}: vkpt does not run there: {}", chosen->name, chosen->unusable));
    return chosen->index;
}

}  // namespace vkpt
