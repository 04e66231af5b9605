// Vulkan through volk's function pointers; nothing links against libvulkan.
#pragma once
#include <volk.h>

#include <string_view>
#include <utility>

namespace vkpt {

/// Throws DeviceError with one clear line unless `result` is VK_SUCCESS. `what` says what was being done, e.g.
/// "allocate buffer 'film' (12 MiB)".
void check(VkResult result, std::string_view what);

/// Owns one object of a VkDevice. Move-only; a moved-from Owned is empty.
/// `Destroy` is the address of volk's pointer to the matching vkDestroy function.
template <class Handle, auto* Destroy>
class Owned {
public:
    Owned() = default;
    Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    Owned(Owned&& other) noexcept : device_(other.device_), handle_(std::exchange(other.handle_, Handle{})) {}
    Owned& operator=(Owned&& other) noexcept {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() {
        if (handle_ != Handle{}) (*Destroy)(device_, handle_, nullptr);
    }
    [[nodiscard]] Handle get() const { return handle_; }

private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = Handle{};
};

}  // namespace vkpt
