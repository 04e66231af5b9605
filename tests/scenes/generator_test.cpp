// The committed scenes are what tools/make_scenes writes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scene_files.h"

namespace vkpt {
namespace {

TEST(MakeScenes, WritesTheCommittedFiles) {
    const std::string command = "python3 '" VKPT_SOURCE "/tools/make_scenes' --check";
    EXPECT_EQ(std::system(command.c_str()), 0) << "scenes/ differs from the output of tools/make_scenes: run it";
}

TEST(MakeScenes, KeepsTheFolderSmall) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VKPT_SCENES))
        if (entry.is_regular_file()) bytes += entry.file_size();
    EXPECT_LT(bytes, 3'000'000U);
}

TEST(MakeScenes, EverySceneStatesFacts) {
    EXPECT_GE(sceneNames().size(), 15U);
    for (const std::string& scene : sceneNames()) {
        const Json expect = expectations(scene);
        std::size_t facts = 0;
        for (const Json& render : expect.at("renders")) facts += render.at("facts").size();
        EXPECT_GT(facts, 2U) << scene;
    }
}

}  // namespace
}  // namespace vkpt
