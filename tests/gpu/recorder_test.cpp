#include "gpu/recorder.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.h"
#include "gpu/transfer.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

namespace {

struct EchoPush {
    std::uint32_t count, offset;
};

/// out = in + push.offset, over kCount words.
class RecorderTest : public GpuTest {
protected:
    static constexpr std::uint32_t kCount = 4096, kGroups = kCount / 64;

    Device& device_ = testDevice();
    Buffer a_{device_, BufferUse::Storage, kCount * 4, "a"}, b_{device_, BufferUse::HostStorage, kCount * 4, "b"};
    Kernel kernel_{device_,
                   probeSpirv("echo"),
                   std::vector{BindingKind::StorageBuffer, BindingKind::StorageBuffer},
                   sizeof(EchoPush),
                   {},
                   "echo"};
    BindGroup ab_{device_, kernel_, std::vector<Binding>{a_, b_}}, ba_{device_, kernel_, std::vector<Binding>{b_, a_}};

    static std::vector<std::uint32_t> all(std::uint32_t value) { return std::vector<std::uint32_t>(kCount, value); }
    std::vector<std::uint32_t> words(const Buffer& buffer) {
        return readStorage<std::uint32_t>(device_, buffer, 0, kCount);
    }
};

TEST_F(RecorderTest, BarriersChainFillKernelsAndCopies) {
    Recorder recorder(device_);
    recorder.begin();
    recorder.fill(a_, 0, a_.size(), 5);
    recorder.barrier();
    recorder.dispatch(kernel_, ab_, EchoPush{kCount, 10}, kGroups);
    recorder.barrier();
    recorder.dispatch(kernel_, ba_, EchoPush{kCount, 100}, kGroups);
    recorder.submitAndWait();
    EXPECT_EQ(words(b_), all(15));
    EXPECT_EQ(words(a_), all(115));
}

TEST_F(RecorderTest, TheSameCommandsRunAgain) {
    const auto zeros = all(0);
    uploadBuffer(device_, a_, 0, std::as_bytes(std::span(zeros)));
    Recorder recorder(device_);
    recorder.begin();
    recorder.dispatch(kernel_, ab_, EchoPush{kCount, 1}, kGroups);
    recorder.barrier();
    recorder.dispatch(kernel_, ba_, EchoPush{kCount, 1}, kGroups);
    recorder.submitAndWait();
    recorder.submit();
    recorder.wait();
    EXPECT_EQ(words(a_), all(4));
}

TEST_F(RecorderTest, IndirectDispatchReadsItsGroupCount) {
    const Buffer args(device_, BufferUse::Indirect, 64, "arguments");
    Recorder recorder(device_);
    recorder.begin();
    const VkDispatchIndirectCommand two{2, 1, 1}, none{0, 1, 1};
    recorder.update(args, 16, std::as_bytes(std::span(&two, 1)));
    recorder.update(args, 32, std::as_bytes(std::span(&none, 1)));
    recorder.fill(a_, 0, a_.size(), 1);
    recorder.fill(b_, 0, b_.size(), 0);
    recorder.barrier();
    recorder.dispatchIndirect(kernel_, ab_, EchoPush{kCount, 6}, args, 16);
    recorder.barrier();
    recorder.dispatchIndirect(kernel_, ab_, EchoPush{kCount, 50}, args, 32);
    recorder.submitAndWait();
    auto expected = all(0);
    std::fill_n(expected.begin(), 128, 7);
    EXPECT_EQ(words(b_), expected);
}

TEST_F(RecorderTest, TimestampsRiseAndUntakenOnesAreNan) {
    Recorder recorder(device_, 4);
    recorder.begin();
    recorder.timestamp(0);
    recorder.fill(a_, 0, a_.size(), 1);
    recorder.barrier();
    for (int i = 0; i < 20; ++i) {
        recorder.dispatch(kernel_, ab_, EchoPush{kCount, 0}, kGroups);
        recorder.barrier();
    }
    recorder.timestamp(2);
    recorder.submitAndWait();
    const auto seconds = recorder.timestampsSeconds();
    if (!device_.info().timestamps) {
        EXPECT_TRUE(seconds.empty());
        return;
    }
    ASSERT_EQ(seconds.size(), 4U);
    EXPECT_EQ(seconds[0], 0);
    EXPECT_GT(seconds[2], 0);
    EXPECT_LT(seconds[2], 10);
    EXPECT_TRUE(std::isnan(seconds[1]) && std::isnan(seconds[3]));
}

TEST_F(RecorderTest, PushConstantsOfTheWrongSizeAreRefused) {
    Recorder recorder(device_);
    recorder.begin();
    EXPECT_THROW(recorder.dispatch(kernel_, ab_, std::uint32_t{1}, 1), std::logic_error);
    EXPECT_THROW(recorder.dispatch(kernel_, ab_, 1), std::logic_error);
}

TEST_F(RecorderTest, TooManyGroupsAreRefused) {
    const std::uint32_t most = device_.info().limits.maxComputeWorkGroupCount;
    if (most == 0xffffffffU) GTEST_SKIP() << "this device states no limit";
    Recorder recorder(device_);
    recorder.begin();
    EXPECT_THAT(
        [&] {
            recorder.dispatch(kernel_, ab_, EchoPush{0, 0}, most + 1);
        },
        testing::ThrowsMessage<DeviceError>(testing::HasSubstr("work groups")));
}

TEST_F(RecorderTest, KernelsBeyondTheDevicesLimitsAreRefused) {
    const std::vector<BindingKind> kinds(device_.info().limits.maxPerStageDescriptorStorageBuffers + 1,
                                         BindingKind::StorageBuffer);
    if (kinds.size() > 4096) GTEST_SKIP() << "this device states no limit";
    EXPECT_THAT([&] { Kernel(device_, probeSpirv("echo"), kinds, 8, {}, "greedy"); },
                testing::ThrowsMessage<DeviceError>(testing::HasSubstr("'greedy'")));
    EXPECT_THROW(Kernel(device_, {}, {}, 0, {}, "absent"), std::logic_error);
}

}  // namespace
}  // namespace vkpt
