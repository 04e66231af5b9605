#include "gpu/buffer.h"

#include <gmock/gmock.h>

#include <numeric>

#include "base/error.h"
#include "gpu/kernel.h"
#include "gpu/memory_plan.h"
#include "gpu/transfer.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Transfer : public GpuTest, public testing::WithParamInterface<TransferPath> {};

TEST_P(Transfer, BytesComeBackWhateverTheirSizeAndOffset) {
    constexpr std::size_t kChunk = std::size_t{16} << 20U;
    const Buffer buffer(testDevice(), BufferUse::Storage, kChunk + 100000, "transfers");
    std::vector<std::uint32_t> words((kChunk + 4) / 4 + 1000);
    std::iota(words.begin(), words.end(), 7U);
    const auto all = std::as_bytes(std::span(words));
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{4097}, kChunk, kChunk + 3}) {
        SCOPED_TRACE(bytes);
        const std::size_t offset = bytes % 2 == 0 ? 0 : 13;
        uploadBuffer(testDevice(), buffer, offset, all.first(bytes), GetParam());
        std::vector<std::byte> back(bytes);
        downloadBuffer(testDevice(), buffer, offset, back, GetParam());
        ASSERT_TRUE(std::ranges::equal(back, all.first(bytes)));
    }
}

INSTANTIATE_TEST_SUITE_P(BothPaths, Transfer, testing::Values(TransferPath::Automatic, TransferPath::Staged),
                         [](const auto& path) { return path.param == TransferPath::Staged ? "Staged" : "Automatic"; });

using BufferTest = GpuTest;

TEST_F(BufferTest, EmptyArraysCanBeBound) {
    const Buffer buffer = makeStorage<std::uint32_t>(testDevice(), {}, "nothing");
    EXPECT_EQ(buffer.size(), 16U);
}

TEST_F(BufferTest, MovingLeavesAnEmptyBuffer) {
    Buffer a(testDevice(), BufferUse::HostStorage, 64, "a");
    const VkBuffer handle = a.handle();
    const Buffer b = std::move(a);
    EXPECT_EQ(b.handle(), handle);
    EXPECT_EQ(a.handle(), VkBuffer{});  // NOLINT(bugprone-use-after-move): the invariant under test
    EXPECT_EQ(b.map().size(), 64U);
}

TEST_F(BufferTest, TooLargeAnAllocationIsRefusedByName) {
    const std::uint64_t tooMuch = testDevice().info().limits.maxMemoryAllocationSize + 4096;
    if (tooMuch > std::uint64_t{1} << 40U) GTEST_SKIP() << "this device states no limit";
    EXPECT_THAT([&] { Buffer(testDevice(), BufferUse::Storage, tooMuch, "huge film"); },
                ThrowsMessage<DeviceError>(HasSubstr("huge film")));
}

TEST_F(BufferTest, TexelViewsBeyondTheLimitAreRefused) {
    const std::uint64_t elements = testDevice().info().limits.maxTexelBufferElements;
    EXPECT_TRUE(TexelView::fits(testDevice(), elements * 16));
    EXPECT_FALSE(TexelView::fits(testDevice(), elements * 16 + 16));
    if (elements > 1U << 27U) GTEST_SKIP() << "a buffer beyond this device's limit is too large for a test";
    const Buffer buffer(testDevice(), BufferUse::Storage, (elements + 1) * 4, "texels");
    EXPECT_THAT([&] { TexelView(testDevice(), buffer, VK_FORMAT_R32_UINT, 0, buffer.size()); },
                ThrowsMessage<DeviceError>(HasSubstr("texels")));
}

TEST_F(BufferTest, StorageRangesBeyondTheLimitAreRefused) {
    const std::uint64_t most = testDevice().info().limits.maxStorageBufferRange;
    if (most > 1U << 28U) GTEST_SKIP() << "a buffer beyond this device's limit is too large for a test";
    const Buffer large(testDevice(), BufferUse::Storage, most + 16, "scene");
    const std::vector kinds{BindingKind::StorageBuffer, BindingKind::StorageBuffer};
    const Kernel kernel(testDevice(), probeSpirv("echo"), kinds, 8, {}, "echo");
    EXPECT_THAT(
        [&] {
            BindGroup(testDevice(), kernel, std::vector<Binding>{large, large});
        },
        ThrowsMessage<DeviceError>(AllOf(HasSubstr("echo"), HasSubstr("scene"))));
    EXPECT_NO_THROW(BindGroup(testDevice(), kernel, std::vector<Binding>{{large, 0, most}, {large, 0, 256}}));
}

TEST(MemoryPlan, RefusesInOneLineWhatDoesNotFit) {
    DeviceInfo device;
    device.name = "tiny";
    device.heapBytes = 300U << 20U;
    device.limits.maxStorageBufferRange = 128U << 20U;
    device.limits.maxMemoryAllocationSize = 200U << 20U;
    MemoryPlan plan;
    plan.add("film", 100U << 20U);
    plan.add("scene", 190U << 20U, false);
    EXPECT_NO_THROW(plan.check(device));
    EXPECT_THAT(plan.describe(), AllOf(HasSubstr("film"), HasSubstr("290.0 MiB")));

    MemoryPlan tooMuch = plan;
    tooMuch.add("paths", 20U << 20U);
    EXPECT_THAT([&] { tooMuch.check(device); }, ThrowsMessage<DeviceError>(HasSubstr("310.0 MiB")));
    MemoryPlan tooLong;
    tooLong.add("film", 129U << 20U);
    EXPECT_THAT([&] { tooLong.check(device); },
                ThrowsMessage<DeviceError>(AllOf(HasSubstr("film"), HasSubstr("128.0 MiB in one storage buffer"))));
    MemoryPlan tooBig;
    tooBig.add("scene", 201U << 20U, false);
    EXPECT_THAT([&] { tooBig.check(device); }, ThrowsMessage<DeviceError>(HasSubstr("in one allocation")));
}

}  // namespace
}  // namespace vkpt
