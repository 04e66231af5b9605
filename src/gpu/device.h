// One Vulkan device with one compute queue.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/device_info.h"
#include "gpu/vulkan.h"

namespace vkpt {

class Instance;
class PipelineCache;

struct DeviceOptions {
    std::string select{};     ///< "", an index or a part of a name: see chooseDevice
    bool validation = false;  ///< validation layers, core and synchronization
};

/// A device ready to compute. Everything made from it must be destroyed before it. Used from one thread at a time.
class Device {
public:
    /// Throws DeviceError (exit 5) where no device fits.
    explicit Device(const DeviceOptions& options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const DeviceInfo& info() const { return info_; }
    [[nodiscard]] VkDevice handle() const { return device_.get(); }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkQueue queue() const { return queue_; }
    [[nodiscard]] PipelineCache& pipelineCache() { return *cache_; }

    /// Index of a memory type among `allowed` that has all of `required`, and of `preferred` if possible.
    [[nodiscard]] std::uint32_t memoryType(std::uint32_t allowed, VkMemoryPropertyFlags required,
                                           VkMemoryPropertyFlags preferred) const;
    [[nodiscard]] VkMemoryPropertyFlags memoryFlags(std::uint32_t type) const;

    /// Gives an object a name that validation messages and debuggers show.
    template <class Handle>
    void setName(VkObjectType type, Handle handle, std::string_view name) const {
        setNameOf(type, (std::uint64_t)handle, name);  // a pointer or an integer, by platform: only a C cast fits both
    }

    /// Warnings and errors of the validation layers since creation (0 without validation), and their first texts.
    [[nodiscard]] std::uint64_t validationMessages() const;
    [[nodiscard]] std::vector<std::string> validationLog() const;

private:
    struct DestroyDevice {
        void operator()(VkDevice device) const { vkDestroyDevice(device, nullptr); }
    };

    void setNameOf(VkObjectType type, std::uint64_t handle, std::string_view name) const;
    void createDevice();

    std::unique_ptr<Instance> instance_;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    DeviceInfo info_;
    std::unique_ptr<VkDevice_T, DestroyDevice> device_;
    VkQueue queue_ = VK_NULL_HANDLE;
    VkPhysicalDeviceMemoryProperties memory_{};
    std::unique_ptr<PipelineCache> cache_;
};

}  // namespace vkpt
