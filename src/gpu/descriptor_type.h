// BindingKind in Vulkan's words.
#pragma once
#include "gpu/kernel.h"

namespace vkpt {

[[nodiscard]] inline VkDescriptorType descriptorType(BindingKind kind) {
    switch (kind) {
        case BindingKind::StorageBuffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        case BindingKind::UniformBuffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case BindingKind::UniformTexel:
            return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
        case BindingKind::StorageTexel:
            return VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
    }
    return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

}  // namespace vkpt
