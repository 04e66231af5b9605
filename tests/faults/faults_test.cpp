// vkpt render while Vulkan calls fail, each in its turn: one clear line, exit code 5, older files untouched, nothing
// left alive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>

#include "cli/command.h"
#include "faults/vulkan_faults.h"
#include "temporary_folder.h"

#if defined(__SANITIZE_ADDRESS__)
/// What the driver and the loader keep for the life of the process. Objects that vkpt forgets are counted by the test
/// itself; what else vkpt forgets is the leak checker's.
extern "C" const char* __lsan_default_suppressions() { return "leak:libvulkan_lvp.so\nleak:libLLVM\n"; }
#endif

namespace vkpt {
namespace {

using Kind = VulkanFaults::Kind;

constexpr const char* kOlder = "an older file";

class Faults : public testing::TestWithParam<Kind> {
protected:
    Faults() {
        // One cache for all: kernels are compiled in the first render only.
        ::setenv("XDG_CACHE_HOME", (cache_.path()).c_str(), 1);
        interceptVulkan();
    }

    /// Renders with the n-th call of the kind failing. The error it ends with, if any.
    std::optional<Error> render(std::uint32_t failAt) {
        vulkanFaults() = {GetParam(), failAt, {}, {}, false, vulkanFaults().alive};
        (void)folder_.write("a.exr", kOlder);
        (void)folder_.write("s.json", kOlder);
        CLI::App app;
        const auto run = kRenderCommand.setup(app);
        app.parse("-q " VKPT_SCENES "/cornell_box/scene.gltf --size 8x8 --spp 3 --max-depth 20 -o " + file("a.exr") +
                  " --stats " + file("s.json"));
        try {
            EXPECT_EQ(run(), ExitCode::Ok);
        } catch (const Error& error) {
            return error;
        }
        return std::nullopt;
    }
    [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
    [[nodiscard]] std::string contents(const char* name) const { return readText(folder_ / name); }

    void expectClean(const std::optional<Error>& error) const {
        const std::string failed = vulkanFaults().failed;
        for (const auto& [object, count] : vulkanFaults().alive) EXPECT_EQ(count, 0) << object << " after " << failed;
        EXPECT_THAT(folder_.files(), testing::ElementsAre("a.exr", "s.json")) << failed;
        if (!error) return;
        EXPECT_EQ(error->code(), ExitCode::Device) << failed;
        EXPECT_THAT(error->what(), testing::StartsWith("Vulkan: ")) << failed;
        EXPECT_THAT(error->what(), testing::Not(testing::HasSubstr("\n"))) << failed;
        const char* reason = GetParam() == Kind::Submission ? "device was lost" : "memory";
        EXPECT_THAT(error->what(), testing::HasSubstr(reason)) << failed;
        EXPECT_EQ(contents("a.exr"), kOlder) << failed;
        EXPECT_EQ(contents("s.json"), kOlder) << failed;
    }

    /// Lets calls fail in their turn: every one, or the first of each function.
    void failInTurn(bool every) {
        ASSERT_FALSE(render(0));
        const std::string image = contents("a.exr");
        ASSERT_NE(image, kOlder);
        ASSERT_FALSE(render(0)) << "kernels and caches as in the renders below";
        expectClean({});
        const std::vector<std::string> calls = vulkanFaults().calls;
        std::set<std::string> failed, survived;
        for (std::uint32_t n = 1; n <= calls.size() && !HasFailure(); ++n) {
            if (!failed.insert(calls[n - 1]).second && !every) continue;
            SCOPED_TRACE(n);
            const std::optional<Error> error = render(n);
            EXPECT_EQ(vulkanFaults().failed, calls[n - 1]);
            if (!error) survived.insert(calls[n - 1]);
            EXPECT_EQ(contents("a.exr"), error ? kOlder : image);
            expectClean(error);
        }
        const bool submissions = GetParam() == Kind::Submission;
        EXPECT_GE(calls.size(), submissions ? 7U : 80U);
        EXPECT_GE(failed.size(), submissions ? 3U : 20U) << testing::PrintToString(failed);
        // What a render can do without: what the driver would keep for the next one, and the wait at the very end.
        for (const std::string& name : survived)
            EXPECT_TRUE(name == "vkGetPipelineCacheData" || name == "vkDeviceWaitIdle") << name;
    }

    TemporaryFolder cache_, folder_;
};

TEST_P(Faults, OfEachFunctionEndInOneLineAndLeaveNothingBehind) { failInTurn(false); }
TEST_P(Faults, FullOfEveryCallEndInOneLineAndLeaveNothingBehind) { failInTurn(true); }

INSTANTIATE_TEST_SUITE_P(Vulkan, Faults, testing::Values(Kind::Allocation, Kind::Submission), [](const auto& param) {
    return param.param == Kind::Allocation ? "OutOfMemory" : "DeviceLost";
});

}  // namespace
}  // namespace vkpt
