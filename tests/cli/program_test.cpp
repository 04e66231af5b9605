// The program as a whole: exit codes, messages, files. Rendering is small and on the CPU where the backend does not
// matter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/json.h"
#include "cli/program.h"
#include "compare/metrics.h"

namespace vkpt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Program, UsageErrorsAre64AndOneLineThatNamesTheFault) {
    const std::pair<Words, const char*> cases[] = {
        {{}, "subcommand"},
        {{"frobnicate"}, "'frobnicate'"},
        {{"--frobnicate"}, "'--frobnicate'"},
        {{"render"}, "SCENE"},
        {{"render", "a.glb", "--frobnicate"}, "--frobnicate"},
        {{"render", "a.glb", "--size", "12"}, "--size"},
        {{"render", "a.glb", "--spp", "none"}, "--spp"},
        {{"render", "a.glb", "--bits", "12"}, "--bits"},
        {{"render", "a.glb", "--tonemap", "filmic"}, "--tonemap"},
        {{"render", "a.glb", "-o", "a.bmp"}, "--output"},
        {{"render", "a.glb", "b.glb"}, "b.glb"},
        {{"render", "a.glb", "--quiet", "--verbose"}, "--quiet"},
        {{"render", kCornellBox, "--samples", "1:99"}, "--samples"},
        {{"render", kCornellBox, "--max-depth", "4294967296"}, "from 0 to 4294967295"},
        {{"render", kCornellBox, "--rr", "fixed:0"}, "P from 0.001 to 1"},
        {{"render", kCornellBox, "--env", "1,-1,1"}, "numbers from 0"},
        {{"render", kCornellBox, "--per-bounce", "--integrator", "ao"}, "--per-bounce"},
        {{"render", kCornellBox, "--max-depth", "4294967295"}, "--max-depth"},
        {{"render", kCornellBox, "--light-groups", "all", "--integrator", "cost"}, "--light-groups"},
        {{"render", kCornellBox, "--light-groups", "nobody", "--backend", "cpu"}, "'nobody'"},
        {{"render", kCornellBox, "--per-bounce", "-o", "a.exr", "-o", "a_bounces.png"}, "a_bounces.png"},
        {{"info"}, "SCENE"},
        {{"bench", "--backend", "gpu"}, "--backend"},
        {{"render", kCornellBox, "--sampler", "lhs", "--scramble", "owen"}, "--scramble"},
        {{"render", kCornellBox, "--sampler", "sobol", "--scramble", "faure"}, "owen|xor|none"},
        {{"samples", "--sampler", "nobody"}, "--sampler"},
        {{"env"}, "FILE"},
        {{"env", "none"}, "FILE"},
        {{"env", "0,0,0"}, "black"},
        {{"env", "studio", "-o", "a.bmp"}, "--output"},
        {{"env", "studio", "--count", "0"}, "--count"},
        {{"bsdf"}, "SPEC"},
        {{"bsdf", "velvet"}, "velvet"},
        {{"bsdf", "lambert", "--compare", "lambert:color=2"}, "--compare"},
        {{"bsdf", "lambert", "-o", "a.bmp"}, "--output"},
        {{"bsdf", "lambert", "--draws", "1"}, "--draws"},
        {{"samples", "--projections", "--dims", "1"}, "--dims"},
        {{"samples", "--radical-inverse", "1"}, "--radical-inverse"},
        {{"samples", "--spectrum", "--discrepancy"}, "--spectrum"},
        {{"samples", "-o", "a.bmp"}, "--output"},
    };
    for (const auto& [words, named] : cases) {
        const RunResult r = run(words);
        EXPECT_EQ(r.code, 64) << named;
        EXPECT_THAT(r.err, testing::StartsWith("vkpt: "));
        EXPECT_THAT(r.err, HasSubstr(named));
        EXPECT_EQ(r.errLines(), 1) << r.err;
        EXPECT_EQ(r.out, "");
    }
}

TEST_F(Program, HelpOfEveryCommandShowsAnExample) {
    EXPECT_EQ(run({"--help"}).code, 0);
    EXPECT_THAT(run({"--version"}).out, testing::StartsWith("vkpt "));
    for (const char* command :
         {"render", "info", "devices", "bench", "diff", "samples", "bsdf", "env", "merge", "verify"}) {
        const RunResult r = run({command, "--help"});
        EXPECT_EQ(r.code, 0);
        EXPECT_THAT(r.out, HasSubstr(std::string("Example:\n  vkpt ") + command));
    }
}

TEST_F(Program, FileFaultsAre4AndOneLineThatNamesTheFile) {
    folder_.write("broken.gltf", "{\"asset\": ");
    Json external = Json::parse(triangleGltf());
    external["buffers"][0]["uri"] = "/dev/null";
    folder_.write("external.gltf", external.dump());
    const std::pair<Words, const char*> cases[] = {
        {{"render", "absent.glb"}, "absent.glb"},
        {{"render", "broken.gltf"}, "broken.gltf"},
        {{"info", "broken.gltf"}, "broken.gltf"},
        {{"bench", "broken.gltf"}, "broken.gltf"},
        {{"info", "external.gltf"}, "external.gltf: buffers[0]: uri \"/dev/null\" leaves the scene's folder"},
        {{"render", "external.gltf"}, "--allow-external"},
        {{"render", kCornellBox, "--env", "absent.hdr"}, "absent.hdr"},
        {{"render", kCornellBox, "-o", "no/such/folder/a.png"}, "no/such/folder/a.png"},
        {{"render", kCornellBox, "--stats", "no/s.json"}, "no/s.json"},
        {{"render", kCornellBox, "--camera", "nobody"}, "nobody"},
    };
    for (const auto& [words, named] : cases) {
        const RunResult r = run(words);
        EXPECT_EQ(r.code, 4) << named;
        EXPECT_THAT(r.err, HasSubstr(named));
        EXPECT_EQ(r.errLines(), 1) << r.err;
    }
    EXPECT_THAT(folder_.files(), ElementsAre("broken.gltf", "external.gltf")) << "nothing was written";
}

TEST_F(Program, WithoutVulkanItSaysSoAndTheCpuStillWorks) {
    const RunOptions noDriver{
        .environment = {"VK_DRIVER_FILES=/nonexistent.json", "VK_ICD_FILENAMES=/nonexistent.json"}};
    EXPECT_EQ(run({"devices"}, noDriver).code, 5);
    const RunResult r = render({}, noDriver);
    EXPECT_EQ(r.code, 5);
    EXPECT_EQ(r.errLines(), 1) << r.err;
    EXPECT_THAT(r.err, HasSubstr("mesa-vulkan-drivers")) << "the package to install";
    EXPECT_EQ(render({"--backend", "cpu"}, noDriver).code, 0);
}

TEST_F(Program, UnknownDeviceIs5) {
    const RunResult r = render({"--device", "no such card"});
    EXPECT_EQ(r.code, 5);
    EXPECT_THAT(r.err, HasSubstr("no such card"));
}

TEST_F(Program, DefaultOutputIsNamedAfterTheScene) {
    EXPECT_EQ(render({"--backend", "cpu"}).code, 0);
    EXPECT_THAT(folder_.files(), ElementsAre("cornell_box.png"));
    EXPECT_EQ(image("cornell_box.png").width, 24U);
}

TEST_F(Program, WritesEveryOutputWithMetadataAndStats) {
    const RunResult r = render({"--backend", "cpu", "-o", "a.png", "-o", "a.exr", "-o", "a.hdr", "-o", "a.pfm",
                                "--seed", "5", "--sampler", "random", "--stats", "s.json", "--quiet", "--bits", "16"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "") << "--quiet has nothing to say";
    EXPECT_THAT(folder_.files(), ElementsAre("a.exr", "a.hdr", "a.pfm", "a.png", "s.json"));
    EXPECT_EQ(attribute("a.exr", "vkpt:seed"), "5");
    EXPECT_EQ(attribute("a.exr", "vkpt:sampler"), "random");
    EXPECT_EQ(attribute("a.exr", "vkpt:spp"), "2");
    EXPECT_EQ(attribute("a.exr", "vkpt:scene"), "scene.gltf");
    EXPECT_EQ(compareImages(image("a.pfm"), image("a.exr")).maximum, 0);

    const Json stats = Json::parse(readText(folder_ / "s.json"));
    EXPECT_EQ(stats.at("spp"), 2);
    EXPECT_EQ(stats.at("paths"), 24 * 16 * 2);
    EXPECT_EQ(stats.at("settingsHash"), attribute("a.exr", "vkpt:settingsHash"));
    EXPECT_GT(stats.at("secondsToFirstPass").get<double>(), 0);
    EXPECT_GE(stats.at("pathRays").get<int>(), 24 * 16 * 2);
    EXPECT_GT(stats.at("seconds").at("total").get<double>(), stats.at("seconds").at("import").get<double>());
}

TEST_F(Program, VulkanAgreesWithTheCpuAndValidationIsSilent) {
    ASSERT_EQ(render({"--validate", "-o", "v.exr", "--stats", "v.json"}).code, 0);
    ASSERT_EQ(render({"--backend", "cpu", "-o", "c.exr"}).code, 0);
    const Json stats = Json::parse(readText(folder_ / "v.json"));
    EXPECT_EQ(stats.at("validationMessages"), 0);
    EXPECT_EQ(stats.at("stages").size() > 3, true);
    EXPECT_LT(compareImages(image("v.exr"), image("c.exr")).meanAbsolute, 0.01);
}

TEST_F(Program, SampleRangesAreThePartsOfTheWhole) {
    ASSERT_EQ(render({"--backend", "cpu", "-o", "whole.exr"}).code, 0);
    ASSERT_EQ(render({"--backend", "cpu", "-o", "a.exr", "--samples", "0:1"}).code, 0);
    ASSERT_EQ(render({"--backend", "cpu", "-o", "b.exr", "--samples", "1:2"}).code, 0);
    const Image whole = image("whole.exr"), a = image("a.exr"), b = image("b.exr");
    for (std::size_t i = 0; i < whole.pixels.size(); ++i)
        ASSERT_NEAR(whole.pixels[i], (a.pixels[i] + b.pixels[i]) / 2, 1e-6F * (1 + whole.pixels[i]));
    EXPECT_EQ(attribute("a.exr", "vkpt:samples"), "0:1");
    EXPECT_EQ(attribute("a.exr", "vkpt:settingsHash"), attribute("whole.exr", "vkpt:settingsHash"));
}

TEST_F(Program, TransparentBackgroundKeepsAlpha) {
    folder_.write("t.gltf", triangleGltf());
    folder_.write("buffer.bin", triangleBuffer());
    const Words base{"render", "t.gltf", "--backend", "cpu", "--size", "16x16", "--spp", "4"};
    Words transparent = base, opaque = base;
    transparent.insert(transparent.end(), {"--background", "transparent", "-o", "t.png"});
    opaque.insert(opaque.end(), {"-o", "o.png"});
    const RunResult r = run(transparent);
    ASSERT_EQ(r.code, 0);
    EXPECT_THAT(r.err, HasSubstr("studio")) << "the log says what lights the scene";
    ASSERT_EQ(run(opaque).code, 0);
    ASSERT_EQ(image("t.png").channels, 4U);
    EXPECT_EQ(image("t.png").at(0, 0)[3], 0);
    EXPECT_EQ(image("o.png").channels, 3U);
}

TEST_F(Program, TimeLimitEndsWithSuccessAndTheTrueCount) {
    const RunResult r = render({"--backend", "cpu", "--time-limit", "0.3", "-o", "a.exr"}, {}, "4000000");
    EXPECT_EQ(r.code, 0) << r.err;
    const int spp = std::stoi(attribute("a.exr", "vkpt:spp"));
    EXPECT_GT(spp, 0);
    EXPECT_LT(spp, 4000000);
    EXPECT_THAT(r.err, HasSubstr("stopped after " + std::to_string(spp) + " of 4000000"));
}

class EveryBackend : public Program, public testing::WithParamInterface<const char*> {};

TEST_P(EveryBackend, InterruptWritesThePictureSoFar) {
    const RunResult r =
        render({"--backend", GetParam(), "-o", "a.exr", "--verbose"}, {.interruptAfter = "Ctrl-C"}, "4000000");
    ASSERT_EQ(r.code, 130) << r.err;
    const std::string spp = attribute("a.exr", "vkpt:spp");
    EXPECT_GT(std::stoi(spp), 0);
    EXPECT_LT(std::stoi(spp), 4000000);
    // The count is true: rendering just these samples gives the same picture, bit for bit.
    ASSERT_EQ(render({"--backend", GetParam(), "-o", "b.exr", "--samples", "0:" + spp}, {}, "4000000").code, 0);
    EXPECT_EQ(image("a.exr").pixels, image("b.exr").pixels);
}

INSTANTIATE_TEST_SUITE_P(Program, EveryBackend, testing::Values("cpu", "vulkan"));

TEST_F(Program, InfoAndDevicesGiveJson) {
    const RunResult info = run({"info", kCornellBox, "--json"});
    ASSERT_EQ(info.code, 0);
    EXPECT_TRUE(Json::parse(info.out).contains("counts"));
    EXPECT_EQ(run({"info", kCornellBox}).code, 0);
    const RunResult devices = run({"devices", "--json"});
    ASSERT_EQ(devices.code, 0) << devices.err;
    EXPECT_TRUE(Json::parse(devices.out).at(0).contains("usable"));
}

TEST_F(Program, BenchTimesBothBackends) {
    const RunResult r = run({"bench", kCornellBox, "--size", "32x32", "--spp", "2", "--repeat", "2", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const Json results = Json::parse(r.out).at("results");
    ASSERT_EQ(results.size(), 2U);
    for (const Json& result : results) {
        EXPECT_EQ(result.at("runSeconds").size(), 2U);
        EXPECT_GT(result.at("millionPathsPerSecond").get<double>(), 0);
        EXPECT_GT(result.at("secondsToFirstPass").get<double>(), 0);
    }
    EXPECT_FALSE(results[0].at("stages").empty());
}

// --spp is rounded before --samples applies.
TEST_F(Program, SampleCountsAreRoundedWithANotice) {
    const RunResult r =
        render({"--backend", "cpu", "--sampler", "orthogonal", "-o", "a.exr", "--samples", "0:9"}, {}, "5");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr("--spp 5: 'orthogonal' takes the square of a prime, so 9"));
    EXPECT_EQ(attribute("a.exr", "vkpt:spp"), "9");
}

// The warnings of --quiet are those that a user must not miss.
TEST_F(Program, SaysWhatAnEstimatorCannotFindAndWhatIsGivenInVain) {
    const RunResult r = run({"render", VKPT_SCENES "/punctual_lights/scene.gltf", "--backend", "cpu", "--size", "8x8",
                             "--spp", "1", "--strategy", "bsdf", "--ao-distance", "1", "--quiet"});
    EXPECT_EQ(r.code, 0);
    EXPECT_EQ(r.errLines(), 2) << r.err;
    EXPECT_THAT(r.err, HasSubstr("warning: --ao-distance has no effect without --integrator ao"));
    EXPECT_THAT(r.err, HasSubstr("how many stay dark: 5"));
    folder_.write("t.gltf", triangleGltf());
    folder_.write("buffer.bin", triangleBuffer());
    for (const char* environment : {"none", "0,0,0"})
        EXPECT_THAT(
            run({"render", "t.gltf", "--backend", "cpu", "--size", "8x8", "--spp", "1", "--env", environment}).err,
            HasSubstr("nothing lights this scene"));
}

// A look is data: its PNG is as it is unless a tone map is asked for. Those of cost and depth are in false colours,
// with a scale: beyond a metre depth would be white.
TEST_F(Program, PngOfALookIsNotToneMapped) {
    const auto look = [&](const char* integrator, const Words& more, const char* file) {
        Words words = {"--backend", "cpu", "--integrator", integrator, "-o", file};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(render(words).code, 0);
        return image(file);
    };
    const Image plain = look("normal", {}, "a.png");
    EXPECT_EQ(plain.pixels, look("normal", {"--tonemap", "none"}, "b.png").pixels);
    EXPECT_NE(plain.pixels, look("normal", {"--tonemap", "neutral"}, "c.png").pixels);
    EXPECT_GT(look("cost", {}, "d.png").height, plain.height);
    const Image depth = look("depth", {}, "e.png");
    EXPECT_GT(depth.height, plain.height);
    const auto [near, far] = std::minmax_element(depth.pixels.begin(), depth.pixels.end());
    EXPECT_LT(*near, *far);
}

// A buffer of 4 GB, of which the disk holds nothing, where the process may have 2.
TEST_F(Program, OutOfHostMemoryIs70AndOneLine) {
    Json scene = Json::parse(triangleGltf());
    scene["buffers"][0]["byteLength"] = 4000000000;
    folder_.write("t.gltf", scene.dump());
    std::filesystem::resize_file(folder_.write("buffer.bin", ""), 4000000000);
    const std::string command = "ulimit -v 2000000; exec '" + std::string(VKPT_BINARY) + "' info '" +
                                (folder_ / "t.gltf").string() + "' 2> '" + (folder_ / "err").string() + "'";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 70);
    EXPECT_EQ(readText(folder_ / "err"), "vkpt: out of memory on the host\n");
}

TEST_F(Program, StandardOutputWithoutSpaceIs4) {
    ASSERT_TRUE(std::ofstream("/dev/full")) << "Linux has this device everywhere";
    const std::string command = std::string(VKPT_BINARY) + " info " + kCornellBox + " > /dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
}

}  // namespace
}  // namespace vkpt
