// A compute kernel, and the buffers bound to it.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/vulkan.h"

namespace vkpt {

/// How a kernel reads what is bound.
enum class BindingKind {
    StorageBuffer,  ///< GLSL buffer block
    UniformBuffer,  ///< GLSL uniform block
    UniformTexel,   ///< GLSL samplerBuffer (or textureBuffer)
    StorageTexel,   ///< GLSL imageBuffer
};

/// A compute pipeline with one descriptor set: binding i has kind bindings[i].
class Kernel {
public:
    Kernel() = default;
    /// specialization[i] is the value of the constant with constant_id = i (floats and bools as bits).
    /// Throws DeviceError where the kernel exceeds a limit of the device or fails to compile.
    Kernel(Device& device, std::span<const std::uint32_t> spirv, std::span<const BindingKind> bindings,
           std::size_t pushBytes, std::span<const std::uint32_t> specialization, std::string_view name);

    [[nodiscard]] VkPipeline pipeline() const { return pipeline_.get(); }
    [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
    [[nodiscard]] VkDescriptorSetLayout setLayout() const { return setLayout_.get(); }
    [[nodiscard]] const std::vector<BindingKind>& bindings() const { return bindings_; }
    [[nodiscard]] std::size_t pushBytes() const { return pushBytes_; }
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    void createLayouts(Device& device);
    void createPipeline(Device& device, std::span<const std::uint32_t> spirv,
                        std::span<const std::uint32_t> specialization);

    std::vector<BindingKind> bindings_;
    std::size_t pushBytes_ = 0;
    std::string name_;
    Owned<VkDescriptorSetLayout, &vkDestroyDescriptorSetLayout> setLayout_;
    Owned<VkPipelineLayout, &vkDestroyPipelineLayout> layout_;
    Owned<VkPipeline, &vkDestroyPipeline> pipeline_;
};

/// A whole buffer, a stretch of one, or a view. The kind is the kernel's.
struct Binding {
    const Buffer* buffer = nullptr;
    const TexelView* view = nullptr;
    std::size_t offset = 0, bytes = VK_WHOLE_SIZE;

    Binding(const Buffer& whole) : buffer(&whole) {}  // NOLINT(google-explicit-constructor): {film, counters}
    Binding(const Buffer& part, std::size_t from, std::size_t count) : buffer(&part), offset(from), bytes(count) {}
    Binding(const TexelView& texels) : view(&texels) {}  // NOLINT(google-explicit-constructor)
};

/// The buffers of one kernel, made once. They must outlive it and every submission that uses it.
/// May be used with every kernel whose bindings have the same kinds.
class BindGroup {
public:
    BindGroup() = default;
    /// Throws DeviceError where a stretch exceeds maxStorageBufferRange or maxUniformBufferRange.
    BindGroup(Device& device, const Kernel& kernel, std::span<const Binding> bindings);

    [[nodiscard]] VkDescriptorSet handle() const { return set_; }

private:
    Owned<VkDescriptorPool, &vkDestroyDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace vkpt
