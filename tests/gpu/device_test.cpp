#include "gpu/device.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <optional>

#include "base/error.h"
#include "gpu/requirements.h"
#include "test_device.h"

namespace vkpt {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

DeviceInfo fake(std::uint32_t index, const char* name, const char* type, const char* unusable = "") {
    DeviceInfo info;
    info.index = index;
    info.name = name;
    info.type = type;
    info.unusable = unusable;
    return info;
}

/// Sets an environment variable for a scope.
class ScopedVariable {
public:
    ScopedVariable(const char* name, const char* value) : name_(name) {
        if (const char* old = getenv(name)) old_ = old;
        setenv(name, value, 1);
    }
    ~ScopedVariable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }

private:
    const char* name_;
    std::optional<std::string> old_;
};

const std::vector<DeviceInfo> kFleet{fake(0, "llvmpipe (LLVM 15)", "CPU"), fake(1, "Small Radeon", "integrated GPU"),
                                     fake(2, "Big GeForce", "discrete GPU", "no compute queue"),
                                     fake(3, "Big Arc", "discrete GPU")};

TEST(ChooseDevice, PrefersAUsableDiscreteGpuAndTakesTheCpuLast) {
    EXPECT_EQ(chooseDevice(kFleet, ""), 3U);
    EXPECT_EQ(chooseDevice({kFleet[0], kFleet[1]}, ""), 1U);
    EXPECT_EQ(chooseDevice({kFleet[0]}, ""), 0U);
}

TEST(ChooseDevice, TakesAnIndexOrPartOfANameInAnyCase) {
    EXPECT_EQ(chooseDevice(kFleet, "1"), 1U);
    EXPECT_EQ(chooseDevice(kFleet, "RADEON"), 1U);
    EXPECT_EQ(chooseDevice(kFleet, "big"), 3U) << "the usable one of two that fit";
}

TEST(ChooseDevice, SaysWhatThereIsOrWhyItDoesNotRun) {
    EXPECT_THAT([] { (void)chooseDevice(kFleet, "9"); }, ThrowsMessage<DeviceError>(HasSubstr("0 llvmpipe")));
    EXPECT_THAT([] { (void)chooseDevice(kFleet, "titan"); }, ThrowsMessage<DeviceError>(HasSubstr("'titan'")));
    EXPECT_THAT([] { (void)chooseDevice(kFleet, "GeForce"); },
                ThrowsMessage<DeviceError>(HasSubstr("no compute queue")));
    EXPECT_THAT([] { (void)chooseDevice({kFleet[2]}, ""); }, ThrowsMessage<DeviceError>(HasSubstr("no compute queue")));
}

TEST(Requirements, NameTheFirstLimitThatIsTooSmall) {
    DeviceInfo info;
    info.apiVersion = VK_API_VERSION_1_2;
    info.limits.maxPerStageDescriptorStorageBuffers = 4;
    info.limits.maxComputeWorkGroupInvocations = 128;
    EXPECT_EQ(unmetRequirement(info), "");
    info.limits.maxPerStageDescriptorStorageBuffers = 3;
    EXPECT_THAT(unmetRequirement(info), HasSubstr("storage buffers"));
    info.apiVersion = VK_API_VERSION_1_1;
    EXPECT_THAT(unmetRequirement(info), HasSubstr("1.1.0"));
}

TEST(ListDevices, DescribesEveryDevice) {
    const auto devices = listDevices();
    ASSERT_FALSE(devices.empty());
    for (const DeviceInfo& device : devices) {
        SCOPED_TRACE(device.name);
        EXPECT_FALSE(device.name.empty() || device.type.empty());
        if (!device.unusable.empty()) continue;
        EXPECT_FALSE(device.driver.empty());
        EXPECT_GE(device.limits.maxStorageBufferRange, 1U << 27U) << "Vulkan's own minimum";
        EXPECT_GE(device.limits.maxTexelBufferElements, 65536U);
        EXPECT_GE(device.limits.maxMemoryAllocationSize, 1U << 30U);
        EXPECT_GT(device.heapBytes, 0U);
        EXPECT_GE(device.subgroupSize, 1U);
    }
}

TEST(ListDevices, NamesThePackageWhereThereIsNoDriver) {
    const ScopedVariable files("VK_DRIVER_FILES", "/nonexistent.json"), old("VK_ICD_FILENAMES", "/nonexistent.json");
    EXPECT_THAT([] { (void)listDevices(); }, ThrowsMessage<DeviceError>(HasSubstr("mesa-vulkan-drivers")));
}

TEST(Check, MapsResultsToOneLineWithExitCode5) {
    try {
        check(VK_ERROR_DEVICE_LOST, "submit work");
        FAIL() << "nothing was thrown";
    } catch (const DeviceError& error) {
        EXPECT_EQ(error.code(), ExitCode::Device);
        EXPECT_THAT(error.what(), testing::StartsWith("Vulkan: submit work: the device was lost"));
    }
    EXPECT_THAT([] { check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "x"); },
                ThrowsMessage<DeviceError>(HasSubstr("out of device memory")));
    EXPECT_THAT([] { check(VK_ERROR_UNKNOWN, "x"); }, ThrowsMessage<DeviceError>(HasSubstr("-13")));
    EXPECT_NO_THROW(check(VK_SUCCESS, "x"));
}

TEST(Device, TwoCanBeOpenAtOnce) {
    const Device other({.select = testDevice().info().name});
    EXPECT_NE(other.handle(), testDevice().handle());
    EXPECT_EQ(other.info().index, testDevice().info().index);
}

}  // namespace
}  // namespace vkpt
