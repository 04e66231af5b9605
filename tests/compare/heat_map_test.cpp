#include "compare/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/false_color.h"
#include "test_images.h"

namespace vkpt {
namespace {

Image ramp(std::uint32_t width, std::uint32_t height, float largest) {
    Image image(width, height, 1);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            *image.at(x, y) = largest * static_cast<float>(x) / static_cast<float>(width - 1);
    return image;
}

void expectColor(const float* pixel, const glm::vec3& color) {
    for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(pixel[c], color[c]);
}

TEST(HeatMap, AbsoluteDifferenceIsTheLargestOfAllChannels) {
    Image a(3, 1, 4), b(3, 1, 4);
    a.at(0, 0)[1] = -0.5F;
    a.at(0, 0)[2] = 0.25F;
    a.at(1, 0)[3] = 1;
    a.at(2, 0)[0] = kNan;
    a.at(2, 0)[1] = 7;
    const Image d = absoluteDifference(a, b);
    EXPECT_EQ(d.pixels[0], 0.5F);
    EXPECT_EQ(d.pixels[1], 1);
    EXPECT_TRUE(std::isnan(d.pixels[2]));
    b.at(2, 0)[0] = kNan;
    EXPECT_EQ(absoluteDifference(a, b).pixels[2], 7) << "NaN in both is no difference";
}

TEST(HeatMap, ScaleEndsAtOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_NEAR(scaleTop(ramp(1000, 1, 0.18F)), 0.2, 1e-12);
    EXPECT_NEAR(scaleTop(ramp(1000, 1, 0.02F)), 0.02, 1e-12);
    EXPECT_NEAR(scaleTop(ramp(1000, 1, 3.1F)), 5, 1e-12);
    EXPECT_NEAR(scaleTop(ramp(1000, 1, 7e-6F)), 1e-5, 1e-16);
    EXPECT_EQ(scaleTop(Image(4, 4, 1)), 1);
}

TEST(HeatMap, FirefliesDoNotDecideTheScaleButTheOnlyDifferenceDoes) {
    Image values = ramp(1000, 1, 0.09F);
    values.pixels[17] = 1000;
    EXPECT_NEAR(scaleTop(values), 0.1, 1e-12);
    Image single(1000, 1, 1);
    single.pixels[17] = 0.3F;
    EXPECT_NEAR(scaleTop(single), 0.5, 1e-12);
}

TEST(HeatMap, ColoursRiseInLuminance) {
    float last = -1;
    for (int i = 0; i <= 100; ++i) {
        const glm::vec3 c = falseColor(static_cast<float>(i) / 100);
        const float luma = 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b;
        EXPECT_GT(luma, last);
        last = luma;
    }
}

TEST(HeatMap, PixelsTakeTheColourOfTheirValue) {
    Image values = ramp(300, 20, 1);
    *values.at(7, 3) = kNan;
    *values.at(8, 3) = 50;
    const Image picture = heatMap(values, {"test", 1});
    ASSERT_EQ(picture.width, 300U);
    ASSERT_GT(picture.height, 20U);
    EXPECT_EQ(picture.channels, 3U);
    expectColor(picture.at(0, 0), falseColor(0));
    expectColor(picture.at(150, 19), falseColor(*values.at(150, 19)));
    expectColor(picture.at(7, 3), {0, 1, 1});
    expectColor(picture.at(8, 3), falseColor(1));
}

TEST(HeatMap, SmallImagesAreEnlargedSoThatTheNumbersFindRoom) {
    const Image picture = heatMap(ramp(10, 4, 1), {"test", 0});
    EXPECT_EQ(picture.width, 260U);
    expectColor(picture.at(259, 26 * 4 - 1), falseColor(1));
    expectColor(picture.at(25, 0), falseColor(0));
}

TEST(HeatMap, BarShowsTheColoursInOrder) {
    const Image picture = heatMap(ramp(300, 20, 1), {"test", 0});
    const std::uint32_t row = 20 + 5 + 11 + 5;  // the middle of the bar at text scale 1
    expectColor(picture.at(12, row), falseColor(0));
    expectColor(picture.at(12 + 275, row), falseColor(1));
}

}  // namespace
}  // namespace vkpt
