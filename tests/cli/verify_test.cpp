// vkpt verify as a user runs it. That it ends with 2 where the renderers disagree is proven by tests/verify/faults_test.
#include <gmock/gmock.h>

#include "base/json.h"
#include "cli/run_vkpt.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

const std::string kScene = std::string(VKPT_SCENES) + "/cornell_box/scene.gltf";

TEST(VerifyCommand, ClimbsEveryRungAndWritesAReport) {
    const TemporaryFolder folder;
    const RunResult run = runVkpt({"verify", kScene, "--size", "24x16", "--spp", "1", "--replicates", "4", "--json",
                                   "--report", "proof", "-q"},
                                  {.folder = folder.path()});
    ASSERT_EQ(run.code, 0) << run.out << run.err;
    EXPECT_EQ(run.err, "");
    const Json report = Json::parse(run.out);
    EXPECT_TRUE(report.at("agrees").get<bool>());
    EXPECT_EQ(report.at("settings").at("size"), "24x16");
    std::vector<std::string> rungs;
    for (const Json& check : report.at("checks")) {
        EXPECT_EQ(check.at("result"), "agrees") << check.dump();
        EXPECT_GT(check.at("compared").get<std::uint64_t>(), 0U) << check.dump();
        if (rungs.empty() || rungs.back() != check.at("rung")) rungs.push_back(check.at("rung"));
    }
    EXPECT_THAT(rungs, testing::ElementsAre("layout", "integers", "functions", "stages", "same seed", "other seeds"));

    for (const char* name : {"gpu.exr", "cpu.exr", "diff.png", "index.html"})
        EXPECT_GT(readText(folder / "proof" / name).size(), 100U) << name;
    const std::string page = readText(folder / "proof" / "index.html");
    EXPECT_THAT(page, testing::HasSubstr("The renderers agree"));
    EXPECT_THAT(page, testing::HasSubstr("src=\"data:image/png;base64,"));
    for (const char* outside : {"http:", "https:", "src=\"/", "url("})
        EXPECT_THAT(page, testing::Not(testing::HasSubstr(outside))) << "the page must need nothing else";
}

TEST(VerifyCommand, ReplaysAPixel) {
    const TemporaryFolder folder;
    const std::vector<std::string> common = {"verify", kScene, "--size", "24x16", "--pixel", "12,14", "--samples", "1:3"};
    const RunResult text = runVkpt(common, {.folder = folder.path()});
    EXPECT_EQ(text.code, 0) << text.out << text.err;
    EXPECT_THAT(text.out, testing::HasSubstr("sample 1: the same on both sides"));
    EXPECT_THAT(text.out, testing::HasSubstr("sample 2: "));
    for (const char* row : {"position", "normal", "material", "light sample", "bsdf sample", "throughput", "emitted"})
        EXPECT_THAT(text.out, testing::HasSubstr(row));

    std::vector<std::string> asJson = common;
    asJson.emplace_back("--json");
    const RunResult json = runVkpt(asJson, {.folder = folder.path()});
    const Json paths = Json::parse(json.out).at("paths");
    ASSERT_EQ(paths.size(), 2U);
    EXPECT_EQ(paths[0].at("sample"), 1);
    EXPECT_TRUE(paths[0].at("partsAtBounce").is_null());
    EXPECT_GT(paths[0].at("vertices").size(), 0U);
}

TEST(VerifyCommand, RefusesWhatItCannotDo) {
    const TemporaryFolder folder;
    const auto code = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"verify", kScene, "--size", "24x16"});
        const RunResult run = runVkpt(more, {.folder = folder.path()});
        EXPECT_EQ(run.errLines(), 1) << run.err;
        return run.code;
    };
    EXPECT_EQ(code({"--pixel", "24,0"}), 64) << "outside the frame";
    EXPECT_EQ(code({"--pixel", "3"}), 64);
    EXPECT_EQ(code({"--replicates", "1"}), 64);
    EXPECT_EQ(code({"--backend", "cpu"}), 64) << "both are needed";
    (void)folder.write("occupied", "a file where the folder should be");
    EXPECT_EQ(code({"--report", "occupied"}), 4);
    EXPECT_EQ(runVkpt({"verify", "absent.gltf"}, {.folder = folder.path()}).code, 4);
}

}  // namespace
}  // namespace vkpt
