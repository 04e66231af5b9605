// The device of a test binary, opened once with validation on.
#pragma once
#include <gtest/gtest.h>

#include "gpu/device.h"

namespace vkpt {

/// Opened at first use. VKPT_TEST_DEVICE selects one as --device does. Without a device the test fails.
inline Device& testDevice() {
    static Device device({.select = getenv("VKPT_TEST_DEVICE") ? getenv("VKPT_TEST_DEVICE") : "", .validation = true});
    return device;
}

/// A test that uses the device; fails where the validation layers say anything during it.
class GpuTest : public testing::Test {
protected:
    void SetUp() override { before_ = testDevice().validationMessages(); }
    void TearDown() override {
        EXPECT_EQ(testDevice().validationMessages(), before_) << "validation: " << testDevice().validationLog().back();
    }

private:
    std::uint64_t before_ = 0;
};

}  // namespace vkpt
