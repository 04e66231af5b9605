#include "gpu/kernel.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "gpu/descriptor_type.h"
#include "gpu/device.h"
#include "gpu/pipeline_cache.h"

namespace vkpt {

namespace {

/// Local size a module declares with OpExecutionMode LocalSize; 0 where it uses another way. [SPIR-V, 3.6]
std::uint64_t localInvocations(std::span<const std::uint32_t> spirv) {
    constexpr std::uint32_t kHeaderWords = 5, kOpExecutionMode = 16, kLocalSize = 17;
    for (std::size_t i = kHeaderWords; i < spirv.size();) {
        const std::uint32_t words = spirv[i] >> 16U;
        if ((spirv[i] & 0xffffU) == kOpExecutionMode && words == 6 && spirv[i + 2] == kLocalSize)
            return std::uint64_t{spirv[i + 3]} * spirv[i + 4] * spirv[i + 5];
        i += std::max(words, 1U);
    }
    return 0;
}

void checkLimits(const DeviceInfo& device, const Kernel& kernel, std::span<const std::uint32_t> spirv) {
    const auto refuse = [&](std::uint64_t needs, std::uint64_t has, std::string_view what) {
        if (needs > has)
            throw DeviceError(fmt::format("kernel '{}' needs {} {}; device '{}' has {}", kernel.name(), needs, what,
                                          device.name, has));
    };
    const auto storage = std::count(kernel.bindings().begin(), kernel.bindings().end(), BindingKind::StorageBuffer);
    refuse(static_cast<std::uint64_t>(storage), device.limits.maxPerStageDescriptorStorageBuffers, "storage buffers");
    refuse(kernel.pushBytes(), device.limits.maxPushConstantsSize, "bytes of push constants");
    refuse(localInvocations(spirv), device.limits.maxComputeWorkGroupInvocations, "invocations a work group");
}

}  // namespace

Kernel::Kernel(Device& device, std::span<const std::uint32_t> spirv, std::span<const BindingKind> bindings,
               std::size_t pushBytes, std::span<const std::uint32_t> specialization, std::string_view name)
    : bindings_(bindings.begin(), bindings.end()), pushBytes_(pushBytes), name_(name) {
    if (spirv.empty()) throw std::logic_error(fmt::format("there is no kernel '{}'", name));
    checkLimits(device.info(), *this, spirv);
    createLayouts(device);
    createPipeline(device, spirv, specialization);
}

void Kernel::createLayouts(Device& device) {
    std::vector<VkDescriptorSetLayoutBinding> slots;
    for (const BindingKind kind : bindings_)
        slots.push_back(
            {static_cast<std::uint32_t>(slots.size()), descriptorType(kind), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    VkDescriptorSetLayoutCreateInfo setInfo{};
    setInfo.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    setInfo.bindingCount = static_cast<std::uint32_t>(slots.size());
    setInfo.pBindings = slots.data();
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    check(vkCreateDescriptorSetLayout(device.handle(), &setInfo, nullptr, &set), name_);
    setLayout_ = {device.handle(), set};

    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, static_cast<std::uint32_t>(pushBytes_)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set;
    info.pushConstantRangeCount = pushBytes_ > 0 ? 1 : 0;
    info.pPushConstantRanges = &push;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout), name_);
    layout_ = {device.handle(), layout};
}

void Kernel::createPipeline(Device& device, std::span<const std::uint32_t> spirv,
                            std::span<const std::uint32_t> specialization) {
    const std::string what = fmt::format("compile kernel '{}'", name_);
    VkShaderModuleCreateInfo moduleInfo{};
    moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    moduleInfo.codeSize = spirv.size_bytes();
    moduleInfo.pCode = spirv.data();
    VkShaderModule shader = VK_NULL_HANDLE;
    check(vkCreateShaderModule(device.handle(), &moduleInfo, nullptr, &shader), what);
    const Owned<VkShaderModule, &vkDestroyShaderModule> module(device.handle(), shader);

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t i = 0; i < specialization.size(); ++i) entries.push_back({i, i * 4, 4});
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         specialization.size_bytes(), specialization.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &constants;
    info.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device.handle(), device.pipelineCache().handle(), 1, &info, nullptr, &pipeline),
          what);
    pipeline_ = {device.handle(), pipeline};
    device.pipelineCache().touch();
    device.setName(VK_OBJECT_TYPE_PIPELINE, pipeline, name_);
}

}  // namespace vkpt
