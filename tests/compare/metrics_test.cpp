#include "compare/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"

namespace vkpt {
namespace {

Image constant(std::uint32_t width, std::uint32_t height, std::uint32_t channels, float value) {
    Image image(width, height, channels);
    for (float& v : image.pixels) v = value;
    return image;
}

TEST(CompareImages, EqualImagesDifferByNothing) {
    const ImageDifference d = compareImages(constant(3, 2, 4, 0.25F), constant(3, 2, 4, 0.25F));
    EXPECT_EQ(d.meanAbsolute, 0);
    EXPECT_EQ(d.rootMeanSquare, 0);
    EXPECT_EQ(d.relativeMse, 0);
    EXPECT_EQ(d.maximum, 0);
}

TEST(CompareImages, OneChangedValueShowsInEveryFigureAndAtItsPlace) {
    Image a = constant(4, 2, 3, 1.0F);
    const Image b = a;
    a.at(2, 1)[1] = 4.0F;
    const ImageDifference d = compareImages(a, b);
    EXPECT_DOUBLE_EQ(d.meanAbsolute, 3.0 / 24);
    EXPECT_DOUBLE_EQ(d.rootMeanSquare, std::sqrt(9.0 / 24));
    EXPECT_DOUBLE_EQ(d.relativeMse, 9.0 / 1.01 / 24);
    EXPECT_EQ(d.maximum, 3);
    EXPECT_EQ(d.x, 2U);
    EXPECT_EQ(d.y, 1U);
}

TEST(CompareImages, AlphaDoesNotCount) {
    Image a = constant(2, 2, 4, 0.5F);
    const Image b = constant(2, 2, 3, 0.5F);
    a.at(0, 0)[3] = 0;
    EXPECT_EQ(compareImages(a, b).maximum, 0);
}

TEST(CompareImages, NotANumberIsNeverHidden) {
    Image a = constant(2, 1, 3, 0.5F);
    const Image b = a;
    a.at(0, 0)[0] = std::numeric_limits<float>::quiet_NaN();
    a.at(1, 0)[0] = 100;
    const ImageDifference d = compareImages(a, b);
    EXPECT_TRUE(std::isnan(d.maximum));
    EXPECT_TRUE(std::isnan(d.meanAbsolute));
}

TEST(CompareImages, DifferentSizesAreRefusedWithExitCode3) {
    try {
        (void)compareImages(constant(2, 2, 3, 0), constant(2, 3, 3, 0));
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::SizeMismatch);
    }
}

}  // namespace
}  // namespace vkpt
