#include "gpu/probe.h"

#include <gmock/gmock.h>

#include <numeric>

#include "gpu/transfer.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

namespace {

using Probe = GpuTest;

std::vector<std::uint32_t> ramp(std::size_t count, std::uint32_t first = 0) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

TEST_F(Probe, EchoesWithPushAndSpecializationConstants) {
    const auto in = ramp(1000, 5);
    const auto out =
        probe<std::uint32_t>(testDevice(), probeSpirv("echo"), "echo", in, 1, {.push = {7}, .specialization = {0xf0}});
    ASSERT_EQ(out.size(), in.size());
    for (std::size_t i = 0; i < in.size(); ++i) ASSERT_EQ(out[i], (in[i] ^ 0xf0U) + 7) << i;
}

TEST_F(Probe, DefaultOfASpecializationConstantHolds) {
    const auto in = ramp(3);
    EXPECT_EQ(probe<std::uint32_t>(testDevice(), probeSpirv("echo"), "echo", in, 1, {.push = {0}}), in);
}

TEST_F(Probe, OutputBeyondTheCountIsZero) {
    const auto in = ramp(4, 1);
    const auto bytes =
        runProbe(testDevice(), probeSpirv("echo"), "echo", std::as_bytes(std::span(in)), 24, 4, {.push = {0}});
    const std::span words(reinterpret_cast<const std::uint32_t*>(bytes.data()), bytes.size() / 4);
    EXPECT_THAT(words, testing::ElementsAre(1, 2, 3, 4, 0, 0));
}

TEST_F(Probe, NoInvocationsAndNoInputAreFine) {
    const auto out =
        probe<std::uint32_t>(testDevice(), probeSpirv("echo"), "echo", std::vector<std::uint32_t>{}, 1, {.push = {0}});
    EXPECT_TRUE(out.empty());
}

TEST_F(Probe, ReadsTexelAndImageBuffers) {
    Device& device = testDevice();
    const auto a = ramp(400, 1), b = ramp(400, 1000), c = ramp(400, 77777);
    const Buffer bBuffer = makeStorage<std::uint32_t>(device, b, "texels"),
                 cBuffer = makeStorage<std::uint32_t>(device, c, "images");
    const TexelView texels(device, bBuffer, VK_FORMAT_R32G32B32A32_UINT, 0, bBuffer.size());
    const TexelView images(device, cBuffer, VK_FORMAT_R32G32B32A32_UINT, 0, cBuffer.size());
    const auto bytes = runProbe(device, probeSpirv("echo_texel"), "echo_texel", std::as_bytes(std::span(a)), 1600, 100,
                                {.extraKinds = {BindingKind::UniformTexel, BindingKind::StorageTexel},
                                 .extra = {Binding(texels), Binding(images)}});
    const std::span words(reinterpret_cast<const std::uint32_t*>(bytes.data()), bytes.size() / 4);
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(words[i], a[i] ^ b[i] ^ c[i]) << i;
}

}  // namespace
}  // namespace vkpt
