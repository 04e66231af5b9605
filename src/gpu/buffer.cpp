#include "gpu/buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/error.h"
#include "gpu/device.h"

namespace vkpt {

namespace {

constexpr VkBufferUsageFlags kCopies = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
constexpr VkBufferUsageFlags kDeviceUsage = kCopies | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                            VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                                            VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT;
constexpr VkMemoryPropertyFlags kMappable = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;

struct Placement {
    VkBufferUsageFlags usage;
    VkMemoryPropertyFlags required, preferred;
};

Placement placementOf(BufferUse use) {
    switch (use) {
        case BufferUse::Storage:
            return {kDeviceUsage, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
        case BufferUse::Indirect:
            return {kDeviceUsage | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
        case BufferUse::HostStorage:
            return {kDeviceUsage, kMappable, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
        case BufferUse::Uniform:
            return {kCopies | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, kMappable, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
        case BufferUse::Upload:
            return {kCopies, kMappable, 0};
        case BufferUse::Readback:
            return {kCopies, kMappable, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
    }
    return {};
}

std::size_t texelSize(VkFormat format) {
    switch (format) {
        case VK_FORMAT_R32_UINT:
        case VK_FORMAT_R32_SFLOAT:
            return 4;
        case VK_FORMAT_R32G32B32A32_UINT:
        case VK_FORMAT_R32G32B32A32_SFLOAT:
            return 16;
        default:
            throw DeviceError(fmt::format("texel format {} is not among those every device takes", int{format}));
    }
}

}  // namespace

Buffer::Buffer(Device& device, BufferUse use, std::size_t bytes, std::string_view name)
    : bytes_(std::max<std::size_t>(bytes, 16)), name_(name) {
    const std::string what = fmt::format("allocate buffer '{}' ({:.1f} MiB)", name, double(bytes_) / (1 << 20));
    const Placement placement = placementOf(use);
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes_;
    info.usage = placement.usage;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer), what);
    buffer_ = {device.handle(), buffer};

    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(device.handle(), buffer, &needs);
    const std::uint64_t largest = device.info().limits.maxMemoryAllocationSize;
    if (needs.size > largest)
        throw DeviceError(fmt::format("{}: device '{}' allocates at most {:.1f} MiB at once", what, device.info().name,
                                      double(largest) / (1 << 20)));
    VkMemoryAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, placement.required, placement.preferred);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(vkAllocateMemory(device.handle(), &allocation, nullptr, &memory), what);
    memory_ = {device.handle(), memory};
    check(vkBindBufferMemory(device.handle(), buffer, memory, 0), what);

    // A CPU device has one memory: mapping it spares the copies of uploads.
    const bool wantsMap = (placement.required & kMappable) != 0 || device.info().isCpu;
    if (wantsMap && (device.memoryFlags(allocation.memoryTypeIndex) & kMappable) == kMappable) {
        void* data = nullptr;
        check(vkMapMemory(device.handle(), memory, 0, VK_WHOLE_SIZE, 0, &data), what);
        data_ = static_cast<std::byte*>(data);
    }
    device.setName(VK_OBJECT_TYPE_BUFFER, buffer, name);
    device.setName(VK_OBJECT_TYPE_DEVICE_MEMORY, memory, name);
}

std::span<std::byte> Buffer::map() const {
    assert(data_ && "a buffer of this use is not visible to the host");
    return {data_, bytes_};
}

TexelView::TexelView(Device& device, const Buffer& buffer, VkFormat format, std::size_t offset, std::size_t bytes) {
    assert(offset % device.info().limits.minTexelBufferOffsetAlignment == 0 && offset + bytes <= buffer.size());
    if (!fits(device, bytes, texelSize(format)))
        throw DeviceError(fmt::format("texel buffer '{}' has {} texels; device '{}' takes {}", buffer.name(),
                                      bytes / texelSize(format), device.info().name,
                                      device.info().limits.maxTexelBufferElements));
    VkBufferViewCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO;
    info.buffer = buffer.handle();
    info.format = format;
    info.offset = offset;
    info.range = bytes;
    VkBufferView view = VK_NULL_HANDLE;
    check(vkCreateBufferView(device.handle(), &info, nullptr, &view),
          fmt::format("view buffer '{}' as texels", buffer.name()));
    view_ = {device.handle(), view};
    device.setName(VK_OBJECT_TYPE_BUFFER_VIEW, view, buffer.name());
}

bool TexelView::fits(const Device& device, std::size_t bytes, std::size_t texelBytes) {
    return bytes / texelBytes <= device.info().limits.maxTexelBufferElements;
}

}  // namespace vkpt
