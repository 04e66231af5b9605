// vkpt diff as a user meets it: figures, exit codes, heat maps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/atomic_file.h"
#include "base/image_read.h"
#include "base/json.h"
#include "cli/run_vkpt.h"
#include "film/encode.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Words = std::vector<std::string>;

/// Grey of 0.5, with `by` added to the red of the first `pixels` pixels.
Image grey(std::uint32_t width, std::uint32_t height, int pixels = 0, float by = 0) {
    Image image(width, height, 3);
    for (float& v : image.pixels) v = 0.5F;
    for (int i = 0; i < pixels; ++i) image.pixels[static_cast<std::size_t>(i) * 3] += by;
    return image;
}

class Diff : public testing::Test {
protected:
    Diff() {
        exr("b.exr", grey(20, 12));
        exr("near.exr", grey(20, 12, 10, 0.05F));
        exr("far.exr", grey(20, 12, 10, 0.5F));
        exr("small.exr", grey(19, 12));
    }
    void exr(const char* name, const Image& image) const { writeFileAtomically(folder_ / name, encodeExr(image, {})); }
    void png(const char* name, const Image& image) const {
        writeFileAtomically(folder_ / name, encodePng(image, 8, {}));
    }
    [[nodiscard]] RunResult run(const Words& more) const {
        Words words{"diff"};
        words.insert(words.end(), more.begin(), more.end());
        return runVkpt(words, {.folder = folder_.path()});
    }
    TemporaryFolder folder_;
};

TEST_F(Diff, ExitCodesFollowTheThresholds) {
    const std::pair<Words, int> cases[] = {
        {{"b.exr", "b.exr"}, 0},
        {{"near.exr", "b.exr"}, 2},
        {{"near.exr", "b.exr", "--fail", "0.1"}, 1},
        {{"near.exr", "b.exr", "--fail", "0.1", "--warn", "0.1"}, 0},
        {{"near.exr", "b.exr", "--failpercent", "5", "--warnpercent", "5"}, 0},
        {{"near.exr", "b.exr", "--failpercent", "4.1"}, 2},
        {{"far.exr", "b.exr", "--failpercent", "50", "--hardfail", "0.4"}, 2},
        {{"far.exr", "b.exr", "--failpercent", "50", "--warnpercent", "50", "--hardwarn", "0.4"}, 1},
        {{"small.exr", "b.exr"}, 3},
        {{"absent.exr", "b.exr"}, 4},
        {{"b.exr"}, 64},
        {{"b.exr", "b.exr", "--fail", "-1"}, 64},
        {{"b.exr", "b.exr", "--failpercent", "101"}, 64},
        {{"b.exr", "b.exr", "-o", "heat.exr"}, 64},
        {{"b.exr", "b.exr", "-o", "no/heat.png"}, 4},
    };
    for (const auto& [words, code] : cases) {
        const RunResult r = run(words);
        EXPECT_EQ(r.code, code) << testing::PrintToString(words) << r.err;
        EXPECT_EQ(r.errLines(), code > 2 ? 1 : 0) << r.err;
        const char* verdicts[] = {"pass\n", "warning\n", "fail\n"};
        EXPECT_THAT(r.out, code <= 2 ? testing::EndsWith(verdicts[code]) : testing::EndsWith(""));
    }
}

TEST_F(Diff, MessagesNameTheFiles) {
    EXPECT_THAT(run({"small.exr", "b.exr"}).err, HasSubstr("small.exr has 19x12 pixels, b.exr has 20x12"));
    png("b.png", grey(20, 12));
    const RunResult mixed = run({"b.png", "b.exr"});
    EXPECT_EQ(mixed.code, 4);
    EXPECT_THAT(mixed.err, HasSubstr("b.png: is display-encoded while b.exr is not"));
    (void)folder_.write("bad.png", "\x89PNG\r\n\x1a\nrubbish");
    EXPECT_EQ(run({"bad.png", "b.png"}).code, 4);
    EXPECT_THAT(run({"b.png", "bad.png"}).err, HasSubstr("bad.png"));
}

TEST_F(Diff, JsonHoldsEveryFigure) {
    const RunResult r = run({"near.exr", "b.exr", "--json", "--flip-per-channel"});
    ASSERT_EQ(r.code, 2);
    const Json json = Json::parse(r.out);
    const double step = 0.05;
    const Json &whole = json.at("whole"), &red = json.at("channels").at("R");
    EXPECT_NEAR(whole.at("mae").get<double>(), step * 10 / 720, 1e-6);
    EXPECT_NEAR(red.at("mae").get<double>(), step * 10 / 240, 1e-6);
    EXPECT_NEAR(red.at("mse").get<double>(), step * step / 24, 1e-6);
    EXPECT_NEAR(red.at("rms").get<double>(), step / std::sqrt(24), 1e-6);
    EXPECT_NEAR(red.at("relMse").get<double>(), step * step / 24 / 0.26, 1e-5);
    EXPECT_NEAR(red.at("mrse").get<double>(), step * step / 24 / (0.51 * 0.51), 1e-5);
    EXPECT_NEAR(red.at("psnr").get<double>(), 10 * std::log10(0.25 / (step * step / 24)), 1e-4);
    EXPECT_NEAR(red.at("maximum").get<double>(), step, 1e-6);
    EXPECT_EQ(json.at("channels").at("G").at("psnr"), nullptr) << "infinite";
    for (const char* figure : {"ssim", "flip"}) {
        EXPECT_GT(whole.at(figure).get<double>(), 0) << figure;
        EXPECT_LT(whole.at(figure).get<double>(), 1) << figure;
    }
    EXPECT_GT(red.at("flip").get<double>(), json.at("channels").at("G").at("flip").get<double>());
    EXPECT_EQ(json.at("peak"), 0.5);
    EXPECT_EQ(json.at("fail").at("pixels"), 10);
    EXPECT_EQ(json.at("verdict"), "fail");
}

TEST_F(Diff, ReadsEveryFormat) {
    const Image a = grey(20, 12, 10, 0.25F), b = grey(20, 12);
    const std::pair<const char*, Bytes (*)(const Image&)> formats[] = {{"hdr", encodeHdr}, {"pfm", encodePfm}};
    for (const auto& [name, encode] : formats) {
        const std::string fileA = std::string("a.") + name, fileB = std::string("b.") + name;
        writeFileAtomically(folder_ / fileA, encode(a));
        writeFileAtomically(folder_ / fileB, encode(b));
        EXPECT_NEAR(Json::parse(run({fileA, fileB, "--json"}).out).at("whole").at("maximum").get<double>(), 0.25, 1e-6);
        EXPECT_EQ(run({fileA, "b.exr", "--fail", "0.3", "--warn", "0.3"}).code, 0) << "linear formats mix";
    }
    png("a.png", a);
    png("b.png", b);
    const Json json = Json::parse(run({"a.png", "b.png", "--json"}).out);
    EXPECT_NEAR(json.at("whole").at("maximum").get<double>(), 63.0 / 255, 1e-6);
    EXPECT_EQ(json.at("peak"), 1);
    EXPECT_EQ(json.at("flipExposures").at("count"), 1);
}

TEST_F(Diff, ValuesThatAreNotFiniteAreReportedAndFail) {
    Image image = grey(20, 12);
    image.at(3, 4)[1] = std::numeric_limits<float>::quiet_NaN();
    image.at(4, 4)[0] = std::numeric_limits<float>::infinity();
    exr("nan.exr", image);
    const RunResult r = run({"nan.exr", "b.exr", "--fail", "1e30", "--failpercent", "100"});
    EXPECT_EQ(r.code, 2);
    EXPECT_THAT(r.out, HasSubstr("not finite: 2 values of the image, 0 of the reference; 2 differ"));
    const Json json = Json::parse(run({"nan.exr", "b.exr", "--json"}).out);
    EXPECT_EQ(json.at("nonFinite").at("image"), 2);
    EXPECT_EQ(json.at("whole").at("mae"), 0);
    EXPECT_EQ(json.at("whole").at("values"), 718);
    EXPECT_EQ(run({"nan.exr", "nan.exr"}).code, 0) << "alike";
}

TEST_F(Diff, HeatMapsShowTheDifference) {
    for (const auto& [map, bright] : {std::pair("absolute", 0.5F), std::pair("flip", 0.1F)}) {
        const RunResult r = run({"far.exr", "b.exr", "-o", "heat.png", "--map", map});
        ASSERT_EQ(r.code, 2) << r.err;
        const Image heat = readImage(folder_ / "heat.png");
        EXPECT_EQ(heat.width, 260U) << "20 pixels, enlarged to make room for the numbers";
        EXPECT_GT(heat.at(5, 5)[0], bright) << "bright where red differs";
        EXPECT_LT(heat.at(259, 155)[0], bright / 2) << "dark where nothing does";
    }
    EXPECT_THAT(folder_.files(), ElementsAre("b.exr", "far.exr", "heat.png", "near.exr", "small.exr"));
}

}  // namespace
}  // namespace vkpt
