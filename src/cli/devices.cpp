// vkpt devices: the Vulkan devices, and whether vkpt runs there.
#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "base/json.h"
#include "cli/command.h"
#include "gpu/device_info.h"

namespace vkpt {
namespace {

Json limitsJson(const DeviceLimits& limits) {
    return {{"maxStorageBufferRange", limits.maxStorageBufferRange},
            {"maxTexelBufferElements", limits.maxTexelBufferElements},
            {"maxMemoryAllocationSize", limits.maxMemoryAllocationSize},
            {"maxPerStageDescriptorStorageBuffers", limits.maxPerStageDescriptorStorageBuffers},
            {"maxComputeWorkGroupCount", limits.maxComputeWorkGroupCount},
            {"maxComputeWorkGroupInvocations", limits.maxComputeWorkGroupInvocations},
            {"maxComputeSharedMemorySize", limits.maxComputeSharedMemorySize}};
}

Json deviceJson(const DeviceInfo& device) {
    return {{"index", device.index},
            {"name", device.name},
            {"type", device.type},
            {"driver", device.driver},
            {"vulkan", versionText(device.apiVersion)},
            {"usable", device.unusable.empty()},
            {"unusable", device.unusable},
            {"memoryBytes", device.heapBytes},
            {"subgroupSize", device.subgroupSize},
            {"subgroupBallot", device.subgroupBallot},
            {"subgroupArithmetic", device.subgroupArithmetic},
            {"timestamps", device.timestamps},
            {"limits", limitsJson(device.limits)}};
}

std::string deviceText(const DeviceInfo& device) {
    constexpr double mib = 1024.0 * 1024.0;
    const DeviceLimits& limits = device.limits;
    std::string text = fmt::format("{}  {} ({})\n   driver {}, Vulkan {}\n", device.index, device.name, device.type,
                                   device.driver, versionText(device.apiVersion));
    text += fmt::format("   memory {:.0f} MiB, storage buffer {:.0f} MiB, texel buffer {} texels, subgroup {}\n",
                        static_cast<double>(device.heapBytes) / mib,
                        static_cast<double>(limits.maxStorageBufferRange) / mib, limits.maxTexelBufferElements,
                        device.subgroupSize);
    text += device.unusable.empty() ? "   vkpt runs here\n"
                                    : fmt::format("   vkpt does not run here: {}\n", device.unusable);
    return text;
}

ExitCode runDevices(bool json) {
    const std::vector<DeviceInfo> devices = listDevices();
    if (json) {
        Json list = Json::array();
        for (const DeviceInfo& device : devices) list.push_back(deviceJson(device));
        std::cout << jsonText(list);
    } else {
        for (const DeviceInfo& device : devices) std::cout << deviceText(device);
    }
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpDevices(CLI::App& app) {
    const auto json = std::make_shared<bool>(false);
    app.add_flag("--json", *json, "as JSON");
    return [json] { return runDevices(*json); };
}

}  // namespace

const Command kDevicesCommand{"devices", "list Vulkan devices and whether vkpt runs there", "vkpt devices",
                              setUpDevices};

}  // namespace vkpt
