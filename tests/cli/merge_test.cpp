// vkpt merge: parts are the whole to the bit, and what does not belong together stays apart.
#include "base/image_read.h"
#include "cli/film_program.h"
#include "film/read_film.h"

namespace vkpt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class MergeOn : public FilmProgram, public testing::WithParamInterface<const char*> {};

// Files and all: pictures, layers, sums, metadata.
TEST_P(MergeOn, PartsInAnyOrderAreTheWholeToTheBit) {
    render(GetParam(), {"-o", "whole.exr", "-o", "whole.png", "--bits", "16"});
    render(GetParam(), {"--samples", "0:3", "-o", "a.exr", "--nthreads", "1"});
    render(GetParam(), {"--samples", "3:4", "-o", "b.exr", "--fetch", "storage"});
    render(GetParam(), {"--samples", "4:8", "-o", "c.exr", "--nthreads", "2"});
    ASSERT_EQ(run({"merge", "c.exr", "a.exr", "b.exr", "-o", "cab.exr", "-o", "cab.png", "--bits", "16"}).code, 0);
    expectSameFile("cab.exr", "whole.exr");
    expectSameFile("cab.png", "whole.png");
    ASSERT_EQ(run({"merge", "a.exr", "b.exr", "-o", "ab.exr"}).code, 0);  // and merged films merge
    ASSERT_EQ(run({"merge", "c.exr", "ab.exr", "-o", "cab2.exr"}).code, 0);
    expectSameFile("cab2.exr", "whole.exr");
}

INSTANTIATE_TEST_SUITE_P(Backends, MergeOn, testing::Values("cpu", "vulkan"));

class Merge : public FilmProgram {
protected:
    void SetUp() override { render("cpu", {"--samples", "0:2", "-o", "a.exr"}); }
};

TEST_F(Merge, RefusesOtherSettingsAndScenes) {
    const std::pair<Words, Words> cases[] = {
        {{"--seed", "3"}, {"seed is 3 here and 0 there"}},
        {{"--spp", "9"}, {"spp is 9 here and 8 there"}},
        {{"--sampler", "random"}, {"sampler is random here and sobol there"}},
        {{"--max-depth", "2"}, {"maxDepth is 2 here and 8 there"}},
        {{"--rr", "fixed:0.5"}, {"rr is fixed:0.5 here and throughput there"}},
        {{"--fov", "20"}, {"right is"}},
        {{"--background", "1,0,0"}, {"background is 1,0,0 here and env there"}},
        {{"--aov", "albedo"}, {"aov is albedo here and albedo,normal"}},
        {{"--per-bounce"}, {"perBounce is 9 here and 0 there"}},
        {{"--light-groups", "all"}, {"lightGroups is [\"light\"] here and [] there"}},
        {{"--env", "studio"}, {"env is studio here and none there"}},
    };
    for (const auto& [options, reasons] : cases) {
        Words words = options;
        words.insert(words.end(), {"--samples", "2:4", "-o", "b.exr"});
        render("cpu", words);
        Words texts{"b.exr: cannot be merged with a.exr: "};
        texts.insert(texts.end(), reasons.begin(), reasons.end());
        expectFault(run({"merge", "a.exr", "b.exr", "-o", "ab.exr"}), 4, texts);
    }
    ASSERT_EQ(run({"render", VKPT_SCENES "/mis_plates/scene.gltf", "--backend", "cpu", "--size", "24x16", "--spp", "8",
                   "--aov", "all", "--samples", "2:4", "-o", "b.exr"})
                  .code,
              0);
    expectFault(run({"merge", "a.exr", "b.exr", "-o", "ab.exr"}), 4, {"b.exr", "a.exr"});
    EXPECT_THAT(folder_.files(), ElementsAre("a.exr", "b.exr", "b_bounces.png", "b_lights.png"))
        << "nothing was written";
}

TEST_F(Merge, RefusesSamplesHeldTwiceAndHoles) {
    render("cpu", {"--samples", "1:4", "-o", "b.exr"});
    render("cpu", {"--samples", "4:6", "-o", "c.exr"});
    expectFault(run({"merge", "a.exr", "b.exr", "-o", "x.exr"}), 4,
                {"b.exr: cannot be merged with a.exr: both hold samples 1:2"});
    expectFault(run({"merge", "a.exr", "a.exr", "-o", "x.exr"}), 4, {"both hold samples 0:2"});
    expectFault(run({"merge", "c.exr", "a.exr", "-o", "x.exr"}), 4,
                {"c.exr: cannot be merged with a.exr: no file holds samples 2:4", "--allow-holes"});
    EXPECT_THAT(folder_.files(), ElementsAre("a.exr", "b.exr", "c.exr"));
    ASSERT_EQ(run({"merge", "c.exr", "a.exr", "-o", "x.exr", "--allow-holes"}).code, 0);
    render("cpu", {"--samples", "2:4", "-o", "d.exr"});
    ASSERT_EQ(run({"merge", "x.exr", "d.exr", "-o", "y.exr"}).code, 0);
    render("cpu", {"--samples", "0:6", "-o", "z.exr"});
    expectSameFile("y.exr", "z.exr");
}

TEST_F(Merge, RefusesFilesWithoutAFilm) {
    render("cpu", {"--samples", "2:4", "-o", "b.exr", "--no-film", "-o", "b.png"});
    expectFault(run({"merge", "a.exr", "b.exr", "-o", "x.exr"}), 4, {"b.exr: ", "--no-film"});
    expectFault(run({"merge", "a.exr", "b.png", "-o", "x.exr"}), 4, {"b.png: "});
    expectFault(run({"merge", "a.exr", "absent.exr", "-o", "x.exr"}), 4, {"absent.exr: cannot be opened"});
    expectFault(run({"merge", "a.exr"}), 64, {"--output"});
    expectFault(run({"merge", "-o", "x.exr"}), 64, {"FILES"});
    expectFault(run({"merge", "a.exr", "-o", "x.gif"}), 64, {"x.gif"});
}

TEST_F(Merge, SaysWhenSamplesAreOfTwoBackends) {
    render("vulkan", {"--samples", "2:8", "-o", "b.exr"});
    const RunResult r = run({"merge", "a.exr", "b.exr", "-o", "ab.exr"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_THAT(r.err, HasSubstr("up to rounding"));
    const FilmRecord record = readFilm(folder_ / "ab.exr");
    EXPECT_EQ(backendsOf(record), "cpu, vulkan");
    ASSERT_EQ(record.sources.size(), 2U);
    EXPECT_EQ(record.sources[0].samples, (SampleRanges{{0, 2}}));
    EXPECT_EQ(record.sources[1].samples, (SampleRanges{{2, 8}}));
}

TEST_F(Merge, LayersOfLightMergeAndHaveContactSheets) {
    const Words light{"--aov", "none", "--per-bounce", "--light-groups", "all"};
    const auto part = [&](Words more) {
        more.insert(more.begin(), light.begin(), light.end());
        render("cpu", more);
    };
    part({"-o", "whole.exr"});
    part({"--samples", "3:8", "-o", "b.exr"});
    part({"--resume", "r.exr", "--samples", "0:3"});
    ASSERT_EQ(run({"merge", "b.exr", "r.exr", "-o", "m.exr"}).code, 0);
    const RunResult taken = run({"merge", "b.exr", "r.exr", "-o", "n.exr", "-o", "n_lights.png"});
    EXPECT_EQ(taken.code, 64);
    EXPECT_THAT(taken.err, HasSubstr("'n_lights.png' is what the contact sheet is called"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "n_lights.png"));
    part({"--resume", "r.exr"});
    for (const char* suffix : {".exr", "_bounces.png", "_lights.png"}) {
        expectSameFile(std::string("m") + suffix, std::string("whole") + suffix);
        expectSameFile(std::string("r") + suffix, std::string("whole") + suffix);
    }
    const FilmRecord record = readFilm(folder_ / "m.exr");
    EXPECT_EQ(record.film.layout.light().lengths, 9U);
    EXPECT_EQ(record.film.layout.light().groups, (std::vector<std::string>{"light"}));
    part({"-o", "plain.exr", "--no-film"});
    EXPECT_EQ(bytes("plain_bounces.png"), bytes("whole_bounces.png"));
}

TEST_F(Merge, DevelopsAFilmAnew) {
    render("cpu",
           {"--background", "transparent", "-o", "t.exr", "-o", "t.png", "--exposure", "1", "--tonemap", "aces"});
    ASSERT_EQ(run({"merge", "t.exr", "-o", "m.png", "-o", "m.pfm", "--exposure", "1", "--tonemap", "aces"}).code, 0);
    expectSameFile("m.png", "t.png");
    const Image film = readImage(folder_ / "t.exr"), floats = readImage(folder_ / "m.pfm");
    for (std::uint32_t i = 0; i < 24 * 16; ++i) ASSERT_EQ(floats.pixels[3 * i + 1], film.pixels[4 * i + 1]);
}

}  // namespace
}  // namespace vkpt
