#include "gpu/device.h"

#include <fmt/format.h>

#include <cstring>

#include "base/error.h"
#include "gpu/flush_denormals.h"
#include "gpu/instance.h"
#include "gpu/pipeline_cache.h"

namespace vkpt {

namespace {

bool hasExtension(VkPhysicalDevice device, const char* name) {
    std::uint32_t count = 0;
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr), "list device extensions");
    std::vector<VkExtensionProperties> extensions(count);
    check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()), "list device extensions");
    for (const auto& extension : extensions)
        if (std::strcmp(extension.extensionName, name) == 0) return true;
    return false;
}

}  // namespace

Device::Device(const DeviceOptions& options)
    : instance_(std::make_unique<Instance>(InstanceOptions{.validation = options.validation})) {
    const std::uint32_t index = chooseDevice(instance_->devices(), options.select);
    physical_ = instance_->physicalDevices().at(index);
    info_ = describeDevice(physical_, index);
    vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
    createDevice();
    vkGetDeviceQueue(device_.get(), info_.queueFamily, 0, &queue_);
    cache_ = std::make_unique<PipelineCache>(*this);
}

void Device::createDevice() {
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueFamilyIndex = info_.queueFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    // An implementation layered on another API offers this extension and then demands that it be enabled.
    const char* portability = "VK_KHR_portability_subset";
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = hasExtension(physical_, portability) ? 1 : 0;
    info.ppEnabledExtensionNames = &portability;
    const FlushDenormals flush;  // the driver may start threads
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical_, &info, nullptr, &device), fmt::format("open device '{}'", info_.name));
    device_.reset(device);
}

Device::~Device() {
    vkDeviceWaitIdle(device_.get());  // nothing can be done here about a lost device
}

std::uint32_t Device::memoryType(std::uint32_t allowed, VkMemoryPropertyFlags required,
                                 VkMemoryPropertyFlags preferred) const {
    for (const VkMemoryPropertyFlags wanted : {required | preferred, required})
        for (std::uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
            if ((allowed >> i & 1U) != 0 && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    throw DeviceError(fmt::format("device '{}' has no memory of the kind needed (flags {:#x})", info_.name, required));
}

VkMemoryPropertyFlags Device::memoryFlags(std::uint32_t type) const { return memory_.memoryTypes[type].propertyFlags; }

void Device::setNameOf(VkObjectType type, std::uint64_t handle, std::string_view name) const {
    if (!instance_->hasDebugUtils()) return;
    const std::string text(name);
    VkDebugUtilsObjectNameInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
    info.objectType = type;
    info.objectHandle = handle;
    info.pObjectName = text.c_str();
    check(vkSetDebugUtilsObjectNameEXT(device_.get(), &info), "name an object");
}

std::uint64_t Device::validationMessages() const { return instance_->validationMessages(); }
std::vector<std::string> Device::validationLog() const { return instance_->validationLog(); }

}  // namespace vkpt
