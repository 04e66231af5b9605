// The Vulkan instance and what its validation layers say.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device_info.h"
#include "gpu/vulkan.h"

namespace vkpt {

struct MessageLog;  // messages of the validation layers; its address is known to the driver

struct InstanceOptions {
    bool validation = false;  ///< VK_LAYER_KHRONOS_validation with core and synchronization checks
};

/// Owns a VkInstance and its debug messenger.
class Instance {
public:
    /// Throws DeviceError without a loader, a driver or (if asked for) the validation layer.
    explicit Instance(const InstanceOptions& options);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const { return instance_; }
    [[nodiscard]] bool hasDebugUtils() const { return debugUtils_; }
    /// Never empty: throws DeviceError where there is no device.
    [[nodiscard]] std::vector<VkPhysicalDevice> physicalDevices() const;
    [[nodiscard]] std::vector<DeviceInfo> devices() const;
    /// Warnings and errors of the validation layers so far, and the first of their texts.
    [[nodiscard]] std::uint64_t validationMessages() const;
    [[nodiscard]] std::vector<std::string> validationLog() const;

private:
    void create(const InstanceOptions& options);
    void createMessenger();

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    bool debugUtils_ = false;
    std::unique_ptr<MessageLog> log_;
};

}  // namespace vkpt
