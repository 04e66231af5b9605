#include "compare/verdict.h"

#include <gtest/gtest.h>

#include <limits>

#include "test_images.h"

namespace vkpt {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

/// Ten black pixels, the first `changed` of which differ by `by` in one channel.
ExitCode verdictOf(int changed, float by, const Threshold& warn, const Threshold& fail) {
    Image image(10, 1, 3);
    const Image reference = image;
    for (int i = 0; i < changed; ++i) image.at(static_cast<std::uint32_t>(i), 0)[i % 3] = by;
    return judge(image, reference, warn, fail).code;
}

TEST(Verdict, ByDefaultAnyDifferenceAboveAMillionthFails) {
    EXPECT_EQ(verdictOf(0, 0, {}, {}), ExitCode::Ok);
    EXPECT_EQ(verdictOf(1, 0.9e-6F, {}, {}), ExitCode::Ok);
    EXPECT_EQ(verdictOf(1, 1.1e-6F, {}, {}), ExitCode::Disagree);
    EXPECT_EQ(verdictOf(1, -1.1e-6F, {}, {}), ExitCode::Disagree);
}

TEST(Verdict, PercentLetsPixelsPass) {
    const Threshold loose{0.5}, fail{0.1, 20};
    EXPECT_EQ(verdictOf(2, 0.2F, loose, fail), ExitCode::Ok) << "20 % of the pixels";
    EXPECT_EQ(verdictOf(3, 0.2F, loose, fail), ExitCode::Disagree);
    EXPECT_EQ(verdictOf(10, 0.05F, loose, fail), ExitCode::Ok);
}

TEST(Verdict, HardThresholdsAllowNoPixel) {
    const Threshold quiet{10}, fail{0.1, 50, 1};
    EXPECT_EQ(verdictOf(1, 0.9F, quiet, fail), ExitCode::Ok);
    EXPECT_EQ(verdictOf(1, 1.1F, quiet, fail), ExitCode::Disagree);
    EXPECT_EQ(verdictOf(1, 1.1F, {10, 0, 1}, {10}), ExitCode::Warning);
}

TEST(Verdict, WarningsComeSecond) {
    const Threshold warn{0.1, 20}, fail{0.5};
    EXPECT_EQ(verdictOf(2, 0.2F, warn, fail), ExitCode::Ok);
    EXPECT_EQ(verdictOf(3, 0.2F, warn, fail), ExitCode::Warning);
    EXPECT_EQ(verdictOf(3, 0.6F, warn, fail), ExitCode::Disagree);
}

TEST(Verdict, APixelCountsOnceAndAlphaCounts) {
    Image image(2, 1, 4);
    const Image reference = image;
    image.at(0, 0)[0] = image.at(0, 0)[1] = 1;
    image.at(1, 0)[3] = 1;
    const Verdict verdict = judge(image, reference, {2}, {});
    EXPECT_EQ(verdict.pixels, 2U);
    EXPECT_EQ(verdict.failed, 2U);
    EXPECT_EQ(verdict.warned, 0U);
}

TEST(Verdict, ValuesFiniteInOneImageOnlyFailWhateverTheThresholds) {
    const Threshold anything{1e30, 100};
    Image image(3, 1, 1), reference = image;
    image.pixels = {kNan, kInfinite, 0};
    reference.pixels = {kNan, kInfinite, 0};
    EXPECT_EQ(judge(image, reference, {}, {}).code, ExitCode::Ok) << "alike";
    reference.pixels[1] = -kInfinite;
    EXPECT_EQ(judge(image, reference, anything, anything).code, ExitCode::Disagree);
    reference.pixels = {kNan, kInfinite, kNan};
    EXPECT_EQ(judge(image, reference, anything, anything).code, ExitCode::Disagree);
}

}  // namespace
}  // namespace vkpt
