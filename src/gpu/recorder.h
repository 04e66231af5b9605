// Records commands, submits them and waits.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/kernel.h"
#include "gpu/vulkan.h"

namespace vkpt {

/// One command buffer. begin(), commands, submitAndWait(); then the same again, or submitAndWait() once more to run
/// the same commands. Commands run in order only across barrier(). What earlier submissions and the host wrote is
/// visible at begin(); what the commands wrote is visible to the host after waiting.
class Recorder {
public:
    /// `timestampSlots` points in time can be taken in one submission.
    explicit Recorder(Device& device, std::uint32_t timestampSlots = 0);
    ~Recorder();  ///< waits for a submission in flight
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    void begin();
    /// Runs `groups` work groups. sizeof(Push) is the kernel's pushBytes().
    template <class Push>
    void dispatch(const Kernel& kernel, const BindGroup& group, const Push& push, std::uint32_t groups) {
        dispatchBytes(kernel, group, std::as_bytes(std::span(&push, 1)), groups);
    }
    void dispatch(const Kernel& kernel, const BindGroup& group, std::uint32_t groups) {
        dispatchBytes(kernel, group, {}, groups);
    }
    /// The same with push constants of a size known at run time only.
    void dispatchBytes(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push,
                       std::uint32_t groups);
    /// The number of groups is read from `args` (a BufferUse::Indirect): a VkDispatchIndirectCommand at `offset`, a
    /// multiple of 4, each of its counts within the device's maxComputeWorkGroupCount.
    template <class Push>
    void dispatchIndirect(const Kernel& kernel, const BindGroup& group, const Push& push, const Buffer& args,
                          std::size_t offset) {
        dispatchIndirectBytes(kernel, group, std::as_bytes(std::span(&push, 1)), args, offset);
    }
    void dispatchIndirect(const Kernel& kernel, const BindGroup& group, const Buffer& args, std::size_t offset) {
        dispatchIndirectBytes(kernel, group, {}, args, offset);
    }
    /// Everything recorded before is finished and visible to everything recorded after: kernels, copies, arguments.
    void barrier();
    /// Sets words to `value`; `offset` and `bytes` are multiples of 4.
    void fill(const Buffer& buffer, std::size_t offset, std::size_t bytes, std::uint32_t value);
    /// Writes up to 64 KiB that are taken from `data` now; sizes are multiples of 4.
    void update(const Buffer& buffer, std::size_t offset, std::span<const std::byte> data);
    void copy(const Buffer& from, std::size_t fromOffset, const Buffer& to, std::size_t toOffset, std::size_t bytes);
    /// Takes the time when everything recorded before has finished. Each slot once a submission.
    void timestamp(std::uint32_t slot);

    void submit();
    void wait();
    void submitAndWait() {
        submit();
        wait();
    }
    /// Seconds of each slot since the earliest of them; NaN where none was taken. Empty where the device has no
    /// timestamps. After wait().
    [[nodiscard]] std::vector<double> timestampsSeconds() const;

private:
    enum class State { Empty, Recording, Ready, InFlight };

    void dispatchIndirectBytes(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push,
                               const Buffer& args, std::size_t offset);
    void bind(const Kernel& kernel, const BindGroup& group, std::span<const std::byte> push);
    void barrierTo(VkPipelineStageFlags stages, VkAccessFlags access);
    void end();

    Device& device_;
    Owned<VkCommandPool, &vkDestroyCommandPool> pool_;
    Owned<VkFence, &vkDestroyFence> fence_;
    Owned<VkQueryPool, &vkDestroyQueryPool> queries_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    std::uint32_t slots_ = 0;
    State state_ = State::Empty;
};

}  // namespace vkpt
