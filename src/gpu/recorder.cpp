#include "gpu/recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "gpu/device.h"

namespace vkpt {

Recorder::Recorder(Device& device, std::uint32_t timestampSlots)
    : device_(device), slots_(device.info().timestamps ? timestampSlots : 0) {
    VkCommandPoolCreateInfo poolInfo{};
    poolInfo.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    poolInfo.queueFamilyIndex = device.info().queueFamily;
    VkCommandPool pool = VK_NULL_HANDLE;
    check(vkCreateCommandPool(device.handle(), &poolInfo, nullptr, &pool), "create a command pool");
    pool_ = {device.handle(), pool};

    VkCommandBufferAllocateInfo bufferInfo{};
    bufferInfo.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    bufferInfo.commandPool = pool;
    bufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    bufferInfo.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(device.handle(), &bufferInfo, &commands_), "allocate a command buffer");

    VkFenceCreateInfo fenceInfo{};
    fenceInfo.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    VkFence fence = VK_NULL_HANDLE;
    check(vkCreateFence(device.handle(), &fenceInfo, nullptr, &fence), "create a fence");
    fence_ = {device.handle(), fence};

    if (slots_ == 0) return;
    VkQueryPoolCreateInfo queryInfo{};
    queryInfo.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    queryInfo.queryType = VK_QUERY_TYPE_TIMESTAMP;
    queryInfo.queryCount = slots_;
    VkQueryPool queries = VK_NULL_HANDLE;
    check(vkCreateQueryPool(device.handle(), &queryInfo, nullptr, &queries), "create a query pool");
    queries_ = {device.handle(), queries};
}

Recorder::~Recorder() {
    if (state_ == State::InFlight) vkDeviceWaitIdle(device_.handle());  // a lost device has nothing in flight
}

void Recorder::begin() {
    assert(state_ != State::InFlight);
    check(vkResetCommandPool(device_.handle(), pool_.get(), 0), "reset a command pool");
    VkCommandBufferBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    check(vkBeginCommandBuffer(commands_, &info), "begin recording");
    state_ = State::Recording;
    if (slots_ > 0) vkCmdResetQueryPool(commands_, queries_.get(), 0, slots_);
    barrier();  // order after the writes of earlier submissions
}

void Recorder::bind(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push) {
    assert(state_ == State::Recording);
    if (push.size() != kernel.pushBytes())
        throw std::logic_error(fmt::format("kernel '{}' takes {} bytes of push constants, not {}", kernel.name(),
                                           kernel.pushBytes(), push.size()));
    const VkDescriptorSet set = group.handle();
    vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.pipeline());
    vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_COMPUTE, kernel.layout(), 0, 1, &set, 0, nullptr);
    if (!push.empty())
        vkCmdPushConstants(commands_, kernel.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           static_cast<std::uint32_t>(push.size()), push.data());
}

void Recorder::dispatchBytes(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push,
                             std::uint32_t groups) {
    const std::uint32_t most = device_.info().limits.maxComputeWorkGroupCount;
    if (groups > most)
        throw DeviceError(fmt::format("kernel '{}' was given {} work groups; device '{}' takes {} at once",
                                      kernel.name(), groups, device_.info().name, most));
    bind(kernel, group, push);
    vkCmdDispatch(commands_, groups, 1, 1);
}

void Recorder::dispatchIndirectBytes(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push,
                                     const Buffer& args, std::size_t offset) {
    assert(offset % 4 == 0 && offset + sizeof(VkDispatchIndirectCommand) <= args.size());
    bind(kernel, group, push);
    vkCmdDispatchIndirect(commands_, args.handle(), offset);
}

void Recorder::barrierTo(VkPipelineStageFlags stages, VkAccessFlags access) {
    VkMemoryBarrier memory{};
    memory.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    memory.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
    memory.dstAccessMask = access;
    // Indirect reads stand among the sources for the sake of arguments that are rewritten afterwards.
    vkCmdPipelineBarrier(
        commands_,
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
        stages, 0, 1, &memory, 0, nullptr, 0, nullptr);
}

void Recorder::barrier() {
    barrierTo(
        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
        VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_UNIFORM_READ_BIT |
            VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_INDIRECT_COMMAND_READ_BIT);
}

void Recorder::fill(const Buffer& buffer, std::size_t offset, std::size_t bytes, std::uint32_t value) {
    assert(state_ == State::Recording && offset % 4 == 0 && bytes % 4 == 0 && offset + bytes <= buffer.size());
    if (bytes > 0) vkCmdFillBuffer(commands_, buffer.handle(), offset, bytes, value);
}

void Recorder::update(const Buffer& buffer, std::size_t offset, std::span<const std::byte> data) {
    assert(state_ == State::Recording && offset % 4 == 0 && data.size() % 4 == 0 && data.size() <= 65536 &&
           offset + data.size() <= buffer.size());
    if (!data.empty()) vkCmdUpdateBuffer(commands_, buffer.handle(), offset, data.size(), data.data());
}

void Recorder::copy(const Buffer& from, std::size_t fromOffset, const Buffer& to, std::size_t toOffset,
                    std::size_t bytes) {
    assert(state_ == State::Recording && fromOffset + bytes <= from.size() && toOffset + bytes <= to.size());
    const VkBufferCopy region{fromOffset, toOffset, bytes};
    if (bytes > 0) vkCmdCopyBuffer(commands_, from.handle(), to.handle(), 1, &region);
}

void Recorder::timestamp(std::uint32_t slot) {
    if (slots_ == 0) return;
    assert(state_ == State::Recording && slot < slots_);
    vkCmdWriteTimestamp(commands_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_.get(), slot);
}

void Recorder::end() {
    barrierTo(VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT | VK_ACCESS_HOST_WRITE_BIT);
    check(vkEndCommandBuffer(commands_), "end recording");
    state_ = State::Ready;
}

void Recorder::submit() {
    if (state_ == State::Recording) end();
    assert(state_ == State::Ready);
    const VkFence fence = fence_.get();
    check(vkResetFences(device_.handle(), 1, &fence), "reset a fence");
    VkSubmitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    check(vkQueueSubmit(device_.queue(), 1, &info, fence), "submit work");
    state_ = State::InFlight;
}

void Recorder::wait() {
    assert(state_ == State::InFlight);
    const VkFence fence = fence_.get();
    check(vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max()),
          "wait for the device");
    state_ = State::Ready;
}

std::vector<double> Recorder::timestampsSeconds() const {
    if (slots_ == 0) return {};
    struct Result {
        std::uint64_t ticks, available;
    };
    std::vector<Result> results(slots_);
    const VkResult status = vkGetQueryPoolResults(device_.handle(), queries_.get(), 0, slots_,
                                                  results.size() * sizeof(Result), results.data(), sizeof(Result),
                                                  VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
    if (status != VK_NOT_READY) check(status, "read timestamps");
    std::uint64_t earliest = std::numeric_limits<std::uint64_t>::max();
    for (const Result& result : results)
        if (result.available != 0) earliest = std::min(earliest, result.ticks);
    std::vector<double> seconds;
    for (const Result& result : results)
        seconds.push_back(result.available != 0
                              ? static_cast<double>(result.ticks - earliest) * device_.info().timestampPeriod
                              : std::nan(""));
    return seconds;
}

}  // namespace vkpt
