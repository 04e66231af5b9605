// Commands that analyse samplers, BSDFs and environments, as a whole: tables, JSON and pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/json.h"
#include "cli/program.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

TEST_F(Program, BsdfGivesTableJsonAndPictures) {
    const RunResult table = run({"bsdf", "conductor:metal=Au", "--draws", "1000", "-o", "a.svg"});
    ASSERT_EQ(table.code, 0) << table.err;
    EXPECT_THAT(table.out, HasSubstr("seen from outside"));
    EXPECT_THAT(readText(folder_.path() / "a.svg"), testing::StartsWith("<svg"));
    const RunResult both =
        run({"bsdf", "dielectric", "--compare", "plastic:alpha=0", "--draws", "1000", "--json", "-o", "a.png"});
    ASSERT_EQ(both.code, 0) << both.err;
    const Json json = Json::parse(both.out);
    EXPECT_EQ(json.at("bsdfs").at(0).at("sides").size(), 2U) << "outside and inside";
    EXPECT_NEAR(json.at("bsdfs").at(0).at("sides").at(0).at("angles").at(0).at("energy").get<double>(), 1, 5e-3);
    EXPECT_EQ(json.at("comparison").size(), 7U);
    EXPECT_GT(image("a.png").width, 100U);
}

TEST_F(Program, EnvGivesTableJsonAndPictures) {
    const RunResult table = run({"env", "studio", "-o", "a.svg"});
    ASSERT_EQ(table.code, 0) << table.err;
    EXPECT_THAT(table.out, HasSubstr("studio: 512x256"));
    EXPECT_THAT(readText(folder_.path() / "a.svg"), testing::StartsWith("<svg"));
    const RunResult json = run({"env", "1,2,3", "--sampler", "orthogonal", "--count", "5", "--json", "-o", "a.png"});
    ASSERT_EQ(json.code, 0) << json.err;
    EXPECT_THAT(json.err, HasSubstr("--count 5: 'orthogonal' takes the square of a prime, so 9"));
    EXPECT_EQ(Json::parse(json.out).at("samples").size(), 9U);
    EXPECT_GT(image("a.png").width, 100U);
    EXPECT_EQ(run({"env", "absent.hdr"}).code, 4);
}

// 8192x4096 texels of one colour: 2 MB as a file of runs, 402 MB as floats. The bound is the one README states.
TEST_F(Program, FullALargeMapTakesBoundedMemory) {
    std::string row("\x02\x02\x20\x00", 4);
    for (const char channel : {'\x80', '\x70', '\x60', '\x81'})
        for (int left = 8192; left > 0; left -= 127) row += {static_cast<char>(128 + std::min(left, 127)), channel};
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4096 +X 8192\n";
    for (int y = 0; y < 4096; ++y) file += row;
    folder_.write("large.hdr", file);
    const RunResult r = render({"--backend", "cpu", "--env", "large.hdr", "--stats", "s.json"}, {}, "1");
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_LT(Json::parse(readText(folder_ / "s.json")).at("peakHostBytes").get<double>(), 1.4e9);
}

TEST_F(Program, SamplesGivesTableJsonAndPictures) {
    const RunResult table =
        run({"samples", "--sampler", "jittered,poissondisk", "--count", "16", "--grid", "-o", "a.svg"});
    ASSERT_EQ(table.code, 0) << table.err;
    EXPECT_THAT(table.out, HasSubstr("jittered: 16 points"));
    EXPECT_THAT(readText(folder_.path() / "a.svg"), testing::StartsWith("<svg"));
    const std::pair<Words, const char*> studies[] = {{{"--projections", "--dims", "0,1,2"}, "points"},
                                                     {{"--projections"}, "points"},
                                                     {{"--discrepancy"}, "l2Star"},
                                                     {{"--spectrum", "--count", "64"}, "radialMean"},
                                                     {{"--convergence", "--count", "16"}, "slope"}};
    for (const auto& [words, field] : studies) {
        Words all{"samples", "--sampler", "sobol", "--json", "-o", "a.png"};
        all.insert(all.end(), words.begin(), words.end());
        const RunResult r = run(all);
        ASSERT_EQ(r.code, 0) << r.err;
        EXPECT_TRUE(Json::parse(r.out).at(0).contains(field)) << field;
        EXPECT_GT(image("a.png").width, 100U);
    }
    const RunResult inverse = run({"samples", "--radical-inverse", "2", "--count", "5", "--json"});
    const Json row = Json::parse(inverse.out).at("rows").at(4);  // the lecture's n = 5: 101, 0.101 = 5/8
    EXPECT_EQ(row.at("inverse"), "0.101");
    EXPECT_EQ(row.at("numerator"), 5);
    EXPECT_EQ(row.at("denominator"), 8);
}

}  // namespace
}  // namespace vkpt
