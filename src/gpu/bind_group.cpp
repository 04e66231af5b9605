#include <fmt/format.h>

#include <cassert>
#include <map>

#include "base/error.h"
#include "gpu/descriptor_type.h"
#include "gpu/device.h"
#include "gpu/kernel.h"

namespace vkpt {

namespace {

/// Room for exactly one set of `kernel`.
VkDescriptorPool createPool(Device& device, const Kernel& kernel) {
    std::map<VkDescriptorType, std::uint32_t> counts;
    for (const BindingKind kind : kernel.bindings()) ++counts[descriptorType(kind)];
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts) sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = 1;
    info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(device.handle(), &info, nullptr, &pool), "create a descriptor pool");
    return pool;
}

void checkRange(const DeviceInfo& device, const Kernel& kernel, BindingKind kind, const Binding& binding) {
    const bool isStorage = kind == BindingKind::StorageBuffer;
    const std::uint64_t largest = isStorage ? device.limits.maxStorageBufferRange : device.limits.maxUniformBufferRange;
    const std::uint64_t bytes =
        binding.bytes == VK_WHOLE_SIZE ? binding.buffer->size() - binding.offset : binding.bytes;
    assert(binding.offset % (isStorage ? device.limits.minStorageBufferOffsetAlignment
                                       : device.limits.minUniformBufferOffsetAlignment) ==
           0);
    if (bytes > largest)
        throw DeviceError(fmt::format("kernel '{}' binds {:.1f} MiB of buffer '{}'; device '{}' takes {:.1f} MiB",
                                      kernel.name(), double(bytes) / (1 << 20), binding.buffer->name(), device.name,
                                      double(largest) / (1 << 20)));
}

}  // namespace

BindGroup::BindGroup(Device& device, const Kernel& kernel, std::span<const Binding> bindings) {
    if (bindings.size() != kernel.bindings().size())
        throw std::logic_error(fmt::format("kernel '{}' has {} bindings, {} were given", kernel.name(),
                                           kernel.bindings().size(), bindings.size()));
    pool_ = {device.handle(), createPool(device, kernel)};
    const VkDescriptorSetLayout layout = kernel.setLayout();
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool_.get();
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    check(vkAllocateDescriptorSets(device.handle(), &info, &set_), "allocate a descriptor set");

    std::vector<VkDescriptorBufferInfo> buffers(bindings.size());
    std::vector<VkBufferView> views(bindings.size());
    std::vector<VkWriteDescriptorSet> writes(bindings.size());
    for (std::uint32_t i = 0; i < bindings.size(); ++i) {
        const BindingKind kind = kernel.bindings()[i];
        const bool isTexel = kind == BindingKind::UniformTexel || kind == BindingKind::StorageTexel;
        if (isTexel != (bindings[i].view != nullptr))
            throw std::logic_error(fmt::format("kernel '{}', binding {}: {} is needed", kernel.name(), i,
                                               isTexel ? "a texel view" : "a buffer"));
        writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[i].dstSet = set_;
        writes[i].dstBinding = i;
        writes[i].descriptorCount = 1;
        writes[i].descriptorType = descriptorType(kind);
        if (isTexel) {
            views[i] = bindings[i].view->handle();
            writes[i].pTexelBufferView = &views[i];
        } else {
            checkRange(device.info(), kernel, kind, bindings[i]);
            buffers[i] = {bindings[i].buffer->handle(), bindings[i].offset, bindings[i].bytes};
            writes[i].pBufferInfo = &buffers[i];
        }
    }
    vkUpdateDescriptorSets(device.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace vkpt
