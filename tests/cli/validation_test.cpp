// What the validation layers say of whole renders beyond core and synchronization checks, which every GPU test runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>

#include "cli/run_vkpt.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

/// Ids of the messages of a small render of a scene, with a feature of the layers on.
std::set<std::string> messagesOf(const std::string& scene, const std::string& feature) {
    const TemporaryFolder folder;
    const RunResult r = runVkpt({"render", std::string(VKPT_SCENES) + "/" + scene + "/scene.gltf", "--size", "24x16",
                                 "--spp", "2", "--validate", "-o", "a.exr"},
                                {.folder = folder.path(), .environment = {"VK_LAYER_ENABLES=" + feature}});
    EXPECT_EQ(r.code, 0) << r.err;
    std::set<std::string> ids;
    const std::regex pattern("Vulkan validation: [^\\[]*\\[ ([^\\]]*) \\]");
    for (std::sregex_iterator match(r.err.begin(), r.err.end(), pattern), end; match != end; ++match)
        ids.insert((*match)[1]);
    return ids;
}

/// Messages that may come, and why.
const std::set<std::string> kJustified{
    // Made with --validate only: the layers are heard through it.
    "UNASSIGNED-BestPractices-vkCreateInstance-specialuse-extension-debugging",
    // A render makes about ten buffers, once: parts of a larger block would save nothing.
    "UNASSIGNED-BestPractices-vkAllocateMemory-small-allocation",
    "UNASSIGNED-BestPractices-vkBindMemory-small-dedicated-allocation",
};

TEST(Layers, BestPracticesSayNothingButTheJustified) {
    const auto ids = messagesOf("cornell_box", "VK_VALIDATION_FEATURE_ENABLE_BEST_PRACTICES_EXT");
    EXPECT_FALSE(ids.empty()) << "the layer listens";
    for (const std::string& id : ids) EXPECT_TRUE(kJustified.contains(id)) << id;
}

// On a device without 64-bit integers in shaders the layer says that it cannot check addresses, which vkpt never takes.
TEST(Layers, FullGpuAssistedFindsNothing) {
    for (const char* scene : {"cornell_box", "instances", "texture_transform", "alpha_modes", "punctual_lights"}) {
        std::set<std::string> ids = messagesOf(scene, "VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT");
        ids.erase("UNASSIGNED-GPU-Assisted Validation Warning");
        EXPECT_THAT(ids, testing::IsEmpty()) << scene;
    }
}

}  // namespace
}  // namespace vkpt
