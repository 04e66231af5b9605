// What the validation layers find. Not GpuTests: these want the layers to speak. Without them, silence elsewhere would
// prove nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "gpu/probe.h"
#include "gpu/recorder.h"
#include "gpu/transfer.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

namespace {

/// Turns a feature of the layers on for the instances made while it lives.
class LayerFeature {
public:
    explicit LayerFeature(const char* name) { ::setenv("VK_LAYER_ENABLES", name, 1); }
    ~LayerFeature() { ::unsetenv("VK_LAYER_ENABLES"); }
    LayerFeature(const LayerFeature&) = delete;
    LayerFeature& operator=(const LayerFeature&) = delete;
};

TEST(Validation, ReportsAMissingBarrier) {
    Device device({.select = testDevice().info().name, .validation = true});
    const Buffer buffer(device, BufferUse::Storage, 4096, "raced");
    Recorder recorder(device);
    recorder.begin();
    recorder.fill(buffer, 0, 4096, 1);
    recorder.fill(buffer, 0, 4096, 2);
    recorder.submitAndWait();
    EXPECT_GT(device.validationMessages(), 0U);
    ASSERT_FALSE(device.validationLog().empty());
    EXPECT_THAT(device.validationLog().front(), testing::HasSubstr("WRITE_AFTER_WRITE"));
}

// The kernel reads eight inputs where there is one. That renders do no such thing: Layers.FullGpuAssistedFindsNothing.
TEST(Validation, GpuAssistedReportsAReadBeyondABuffer) {
    const LayerFeature feature("VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT");
    Device device({.select = testDevice().info().name, .validation = true});
    const std::array<std::uint32_t, 4> input{};
    const auto beyond = testing::HasSubstr("access out of bounds");
    EXPECT_THAT(device.validationLog(), testing::Not(testing::Contains(beyond)));
    (void)runProbe(device, probeSpirv("hash"), "hash", std::as_bytes(std::span(input)), 4096, 8);
    EXPECT_THAT(device.validationLog(), testing::Contains(beyond));
}

}  // namespace
}  // namespace vkpt
