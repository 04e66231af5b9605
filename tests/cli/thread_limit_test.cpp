#include "cli/thread_limit.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/info.h>

#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

#include "base/cpu.h"
#include "gpu/device.h"

namespace vkpt {
namespace {

std::ptrdiff_t threads() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), std::filesystem::directory_iterator());
}

/// Threads that opening a device starts.
std::ptrdiff_t threadsOfDriver(std::string& driver) {
    const std::ptrdiff_t before = threads();
    const Device device({.select = getenv("VKPT_TEST_DEVICE") ? getenv("VKPT_TEST_DEVICE") : ""});
    driver = device.info().name;
    return threads() - before;
}

TEST(ThreadLimit, HoldsForLavapipe) {
    std::string driver;
    const std::ptrdiff_t all = threadsOfDriver(driver);
    if (driver.find("llvmpipe") == std::string::npos) GTEST_SKIP() << driver << " chooses its own threads";
    const ThreadLimit limit(1);
    const std::ptrdiff_t one = threadsOfDriver(driver);
    if (std::thread::hardware_concurrency() > 1)
        EXPECT_LT(one, all);
    else
        EXPECT_LE(one, all);
}

TEST(ThreadLimit, LeavesTheUsersOwnChoiceOfDriverThreads) {
    ::setenv("LP_NUM_THREADS", "7", 1);
    {
        const ThreadLimit limit(1);
        EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "7");
    }
    EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "7");
    ::unsetenv("LP_NUM_THREADS");
    {
        const ThreadLimit limit(3);
        EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "3");
    }
    EXPECT_EQ(std::getenv("LP_NUM_THREADS"), nullptr);
}

TEST(ThreadLimit, WithoutALimitTheDriverHasSeveralThreadsACore) {
    ::unsetenv("LP_NUM_THREADS");
    {
        const ThreadLimit none(0);
        const char* threads = std::getenv("LP_NUM_THREADS");
        ASSERT_NE(threads, nullptr);
        EXPECT_GT(std::stoul(threads), static_cast<unsigned>(tbb::info::default_concurrency()));
    }
    EXPECT_EQ(std::getenv("LP_NUM_THREADS"), nullptr);
}

TEST(ThreadLimit, LavapipesVectorsAreAsWideAsTheProcessorComputesThem) {
    const char* const name = "LP_NATIVE_VECTOR_WIDTH";
    const char* const set = std::getenv(name);
    const std::string before = set != nullptr ? set : "";
    ::unsetenv(name);
    {
        const ThreadLimit none(0);
        if (computes512Bits())
            EXPECT_STREQ(std::getenv(name), "512");
        else
            EXPECT_EQ(std::getenv(name), nullptr);
    }
    EXPECT_EQ(std::getenv(name), nullptr);
    ::setenv(name, "256", 1);
    {
        const ThreadLimit none(0);
        EXPECT_STREQ(std::getenv(name), "256");
    }
    EXPECT_STREQ(std::getenv(name), "256");
    ::unsetenv(name);
    if (!before.empty()) ::setenv(name, before.c_str(), 1);
}

}  // namespace
}  // namespace vkpt
