#include <fmt/format.h>

#include "base/error.h"
#include "gpu/vulkan.h"

namespace vkpt {

namespace {

std::string_view explain(VkResult result) {
    switch (result) {
        case VK_ERROR_DEVICE_LOST:
            return "the device was lost (driver crash or watchdog time-out)";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "out of device memory";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "the driver is out of host memory";
        case VK_ERROR_OUT_OF_POOL_MEMORY:
            return "out of descriptor memory";
        case VK_ERROR_TOO_MANY_OBJECTS:
            return "too many memory allocations";
        case VK_ERROR_INITIALIZATION_FAILED:
            return "the driver could not be initialised";
        case VK_ERROR_INCOMPATIBLE_DRIVER:
            return "no Vulkan driver is installed; install one, e.g. package mesa-vulkan-drivers";
        case VK_ERROR_LAYER_NOT_PRESENT:
            return "a layer is missing; validation needs package vulkan-validationlayers";
        case VK_ERROR_EXTENSION_NOT_PRESENT:
            return "an extension is missing";
        case VK_ERROR_FEATURE_NOT_PRESENT:
            return "a feature is missing";
        default:
            return {};
    }
}

}  // namespace

void check(VkResult result, std::string_view what) {
    if (result == VK_SUCCESS) return;
    const std::string_view reason = explain(result);
    if (reason.empty()) throw DeviceError(fmt::format("Vulkan: {}: error {}", what, static_cast<int>(result)));
    throw DeviceError(fmt::format("Vulkan: {}: {}", what, reason));
}

}  // namespace vkpt
