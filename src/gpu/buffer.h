// Buffers with their memory, and typed views of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "gpu/vulkan.h"

namespace vkpt {

class Device;

/// What a buffer is for; it decides usage flags and kind of memory.
enum class BufferUse {
    Storage,      ///< device memory: storage buffer, texel buffers, copies
    Indirect,     ///< Storage that also holds arguments of indirect dispatches
    HostStorage,  ///< storage buffer the host can map: small results read after each submit
    Uniform,      ///< written by the host, read by kernels
    Upload,       ///< written by the host, copied from
    Readback,     ///< copied to, read by the host
};

/// Owns a VkBuffer and its memory. Move-only; a moved-from Buffer is empty.
/// `name` appears in validation messages and in every error this class throws.
class Buffer {
public:
    Buffer() = default;
    /// A size of 0 becomes 16, so that an absent array can still be bound. Throws DeviceError where the size exceeds
    /// a limit of the device or the memory is not there. Contents are undefined.
    Buffer(Device& device, BufferUse use, std::size_t bytes, std::string_view name);

    [[nodiscard]] VkBuffer handle() const { return buffer_.get(); }
    [[nodiscard]] std::size_t size() const { return bytes_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] bool isMappable() const { return data_ != nullptr; }
    /// The memory as the host sees it; coherent. Host-visible uses only (and Storage where isMappable()): the host
    /// may touch it while no submission that uses the buffer is in flight.
    [[nodiscard]] std::span<std::byte> map() const;

private:
    Owned<VkDeviceMemory, &vkFreeMemory> memory_;  // freed after the buffer that is bound to it
    Owned<VkBuffer, &vkDestroyBuffer> buffer_;
    std::size_t bytes_ = 0;
    std::byte* data_ = nullptr;
    std::string name_;
};

/// A stretch of a buffer read as texels of one format (GLSL samplerBuffer or imageBuffer).
class TexelView {
public:
    TexelView() = default;
    /// Throws DeviceError where `bytes` holds more texels than the device's maxTexelBufferElements.
    /// Formats: R32_UINT, R32_SFLOAT, R32G32B32A32_UINT, R32G32B32A32_SFLOAT, which every device takes.
    TexelView(Device& device, const Buffer& buffer, VkFormat format, std::size_t offset, std::size_t bytes);

    [[nodiscard]] VkBufferView handle() const { return view_.get(); }
    /// Whether a view of `bytes` bytes of 16-byte texels fits the device's limit.
    [[nodiscard]] static bool fits(const Device& device, std::size_t bytes, std::size_t texelBytes = 16);

private:
    Owned<VkBufferView, &vkDestroyBufferView> view_;
};

}  // namespace vkpt
