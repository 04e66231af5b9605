#include "faults/vulkan_faults.h"

#include <array>
#include <cstring>
#include <tuple>
#include <type_traits>

#include "gpu/instance.h"

namespace vkpt {
namespace {

using Kind = VulkanFaults::Kind;

struct CallInfo {
    const char* name = nullptr;
    Kind kind = Kind::Allocation;
    const char* object = nullptr;  ///< name of the vkCreate function that this call belongs to
    int change = 0;                ///< +1: it makes such an object, -1: it destroys one
    bool waits = false;            ///< it waits even where it fails: the device that is said to be lost still works
};

/// The error that the next call meets.
VkResult nextFault(const CallInfo& info) {
    VulkanFaults& faults = vulkanFaults();
    if (faults.lost) return VK_ERROR_DEVICE_LOST;
    if (info.kind != faults.kind) return VK_SUCCESS;
    faults.calls.emplace_back(info.name);
    if (faults.calls.size() != faults.failAt) return VK_SUCCESS;
    faults.failed = info.name;
    faults.lost = info.kind == Kind::Submission;
    if (faults.lost) return VK_ERROR_DEVICE_LOST;
    return std::strcmp(info.name, "vkAllocateMemory") == 0 ? VK_ERROR_OUT_OF_DEVICE_MEMORY
                                                           : VK_ERROR_OUT_OF_HOST_MEMORY;
}

/// The wrapper of the function behind volk's pointer `Pointer`.
template <auto* Pointer, class Function = std::remove_pointer_t<decltype(Pointer)>>
struct Call;

template <auto* Pointer, class Result, class... Args>
struct Call<Pointer, Result(VKAPI_PTR*)(Args...)> {
    static inline Result(VKAPI_PTR* real)(Args...) = nullptr;
    static inline CallInfo info;

    static VKAPI_ATTR Result VKAPI_CALL wrapped(Args... args) {
        if constexpr (std::is_same_v<Result, VkResult>) {
            const VkResult fault = nextFault(info);
            if (fault != VK_SUCCESS && !info.waits) return fault;
            const VkResult result = real(args...);
            if (fault != VK_SUCCESS) return fault;
            if (result == VK_SUCCESS && info.change > 0) ++vulkanFaults().alive[info.object];
            return result;
        } else {
            // vkDestroyX(owner, object, …) and vkFreeMemory; vkDestroyInstance and vkDestroyDevice have no owner.
            constexpr std::size_t object = sizeof...(Args) == 3 ? 1 : 0;
            if (std::get<object>(std::tuple(args...)) != VK_NULL_HANDLE) --vulkanFaults().alive[info.object];
            real(args...);
        }
    }
};

struct Entry {
    const char* name;
    PFN_vkVoidFunction wrapped;
    void (*setReal)(PFN_vkVoidFunction);
};

template <auto* Pointer>
Entry entry(const CallInfo& info) {
    using Wrapper = Call<Pointer>;
    Wrapper::info = info;
    return {info.name, reinterpret_cast<PFN_vkVoidFunction>(&Wrapper::wrapped),
            [](PFN_vkVoidFunction function) { Wrapper::real = reinterpret_cast<decltype(Wrapper::real)>(function); }};
}

template <auto* Create, auto* Destroy>
std::array<Entry, 2> pair(const char* create, const char* destroy) {
    return {entry<Create>({create, Kind::Allocation, create, 1}), entry<Destroy>({destroy, {}, create, -1})};
}

std::vector<Entry> makeEntries() {
    std::vector<Entry> entries;
    for (const auto& both : {
             pair<&vkCreateInstance, &vkDestroyInstance>("vkCreateInstance", "vkDestroyInstance"),
             pair<&vkCreateDevice, &vkDestroyDevice>("vkCreateDevice", "vkDestroyDevice"),
             pair<&vkAllocateMemory, &vkFreeMemory>("vkAllocateMemory", "vkFreeMemory"),
             pair<&vkCreateBuffer, &vkDestroyBuffer>("vkCreateBuffer", "vkDestroyBuffer"),
             pair<&vkCreateBufferView, &vkDestroyBufferView>("vkCreateBufferView", "vkDestroyBufferView"),
             pair<&vkCreateDescriptorSetLayout, &vkDestroyDescriptorSetLayout>("vkCreateDescriptorSetLayout",
                                                                               "vkDestroyDescriptorSetLayout"),
             pair<&vkCreatePipelineLayout, &vkDestroyPipelineLayout>("vkCreatePipelineLayout",
                                                                     "vkDestroyPipelineLayout"),
             pair<&vkCreateShaderModule, &vkDestroyShaderModule>("vkCreateShaderModule", "vkDestroyShaderModule"),
             pair<&vkCreateComputePipelines, &vkDestroyPipeline>("vkCreateComputePipelines", "vkDestroyPipeline"),
             pair<&vkCreatePipelineCache, &vkDestroyPipelineCache>("vkCreatePipelineCache", "vkDestroyPipelineCache"),
             pair<&vkCreateDescriptorPool, &vkDestroyDescriptorPool>("vkCreateDescriptorPool",
                                                                     "vkDestroyDescriptorPool"),
             pair<&vkCreateCommandPool, &vkDestroyCommandPool>("vkCreateCommandPool", "vkDestroyCommandPool"),
             pair<&vkCreateFence, &vkDestroyFence>("vkCreateFence", "vkDestroyFence"),
             pair<&vkCreateQueryPool, &vkDestroyQueryPool>("vkCreateQueryPool", "vkDestroyQueryPool"),
         })
        entries.insert(entries.end(), both.begin(), both.end());
    entries.insert(entries.end(),
                   {
                       entry<&vkEnumerateInstanceExtensionProperties>({"vkEnumerateInstanceExtensionProperties"}),
                       entry<&vkEnumeratePhysicalDevices>({"vkEnumeratePhysicalDevices"}),
                       entry<&vkEnumerateDeviceExtensionProperties>({"vkEnumerateDeviceExtensionProperties"}),
                       entry<&vkBindBufferMemory>({"vkBindBufferMemory"}),
                       entry<&vkMapMemory>({"vkMapMemory"}),
                       entry<&vkAllocateDescriptorSets>({"vkAllocateDescriptorSets"}),
                       entry<&vkAllocateCommandBuffers>({"vkAllocateCommandBuffers"}),
                       entry<&vkResetCommandPool>({"vkResetCommandPool"}),
                       entry<&vkBeginCommandBuffer>({"vkBeginCommandBuffer"}),
                       entry<&vkEndCommandBuffer>({"vkEndCommandBuffer"}),
                       entry<&vkResetFences>({"vkResetFences"}),
                       entry<&vkGetQueryPoolResults>({"vkGetQueryPoolResults"}),
                       entry<&vkGetPipelineCacheData>({"vkGetPipelineCacheData"}),
                       entry<&vkQueueSubmit>({"vkQueueSubmit", Kind::Submission}),
                       entry<&vkWaitForFences>({"vkWaitForFences", Kind::Submission, nullptr, 0, true}),
                       entry<&vkDeviceWaitIdle>({"vkDeviceWaitIdle", Kind::Submission, nullptr, 0, true}),
                   });
    return entries;
}

PFN_vkGetInstanceProcAddr realGetInstanceProcAddr = nullptr;

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance, const char* name) {
    static const std::vector<Entry> entries = makeEntries();
    const PFN_vkVoidFunction function = realGetInstanceProcAddr(instance, name);
    for (const Entry& e : entries) {
        if (function == nullptr || std::strcmp(e.name, name) != 0) continue;
        e.setReal(function);
        return e.wrapped;
    }
    return function;
}

}  // namespace

VulkanFaults& vulkanFaults() {
    static VulkanFaults faults;
    return faults;
}

void interceptVulkan() {
    if (realGetInstanceProcAddr != nullptr) return;
    const Instance first({});  // loads the loader, once a process
    realGetInstanceProcAddr = vkGetInstanceProcAddr;
    volkInitializeCustom(getInstanceProcAddr);
    volkLoadInstance(first.handle());  // so that destroying it is not counted against another
    ++vulkanFaults().alive["vkCreateInstance"];
}

}  // namespace vkpt
