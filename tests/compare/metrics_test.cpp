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

TEST(CompareImages, EveryFigureFollowsItsFormula) {
    Image a(2, 1, 1), r(2, 1, 1);
    a.pixels = {0.5F, 3.0F};
    r.pixels = {0.25F, 2.0F};
    const ImageDifference d = compareImages(a, r);
    EXPECT_DOUBLE_EQ(d.meanAbsolute, (0.25 + 1) / 2);
    EXPECT_DOUBLE_EQ(d.meanSquare, (0.0625 + 1) / 2);
    EXPECT_DOUBLE_EQ(d.relativeMse, (0.0625 / (0.0625 + 0.01) + 1 / (4 + 0.01)) / 2);
    EXPECT_DOUBLE_EQ(d.mrse, (0.0625 / (0.26 * 0.26) + 1 / (2.01 * 2.01)) / 2);
    EXPECT_DOUBLE_EQ(d.peak, 2);
    EXPECT_DOUBLE_EQ(d.psnr, 10 * std::log10(4 / d.meanSquare));
    EXPECT_DOUBLE_EQ(compareImages(a, r, 1.0).psnr, 10 * std::log10(1 / d.meanSquare));
    EXPECT_EQ(compareImages(a, a).psnr, std::numeric_limits<double>::infinity());
}

TEST(CompareImages, TheWholeIsTheMeanOfItsColourChannelsAndAlphaStandsAlone) {
    Image a = constant(2, 2, 4, 0.5F);
    const Image b = constant(2, 2, 4, 0.5F);
    a.at(1, 0)[0] = 0.9F;
    a.at(0, 1)[2] = 0.3F;
    a.at(0, 0)[3] = 0;
    const ImageDifference d = compareImages(a, b);
    ASSERT_EQ(d.channels.size(), 4U);
    EXPECT_EQ(d.channels[0].name, "R");
    EXPECT_EQ(d.channels[3].name, "A");
    EXPECT_EQ(d.channels[1].maximum, 0);
    EXPECT_NEAR(d.channels[2].maximum, 0.2, 1e-6);
    EXPECT_EQ(d.channels[3].maximum, 0.5);
    EXPECT_DOUBLE_EQ(d.meanSquare, (d.channels[0].meanSquare + d.channels[2].meanSquare) / 3);
    EXPECT_NEAR(d.maximum, 0.4, 1e-6) << "alpha is not in the whole";
}

TEST(CompareImages, AGreyImageFacesEveryColour) {
    Image grey = constant(2, 1, 1, 0.5F), color = constant(2, 1, 3, 0.5F);
    color.at(1, 0)[2] = 0.75F;
    const ImageDifference d = compareImages(grey, color);
    EXPECT_EQ(d.values, 6U);
    EXPECT_DOUBLE_EQ(d.meanAbsolute, 0.25 / 6);
    EXPECT_EQ(compareImages(color, grey).meanAbsolute, d.meanAbsolute);
    EXPECT_EQ(compareImages(grey, grey).channels.at(0).name, "Y");
}

TEST(CompareImages, WhatIsNotFiniteIsCountedAndLeftOutOfTheMeans) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    Image a = constant(4, 1, 3, 0.5F), b = a;
    a.at(0, 0)[0] = nan;
    b.at(1, 0)[1] = infinite;
    a.at(2, 0)[0] = b.at(2, 0)[0] = nan;          // alike: no difference
    a.at(2, 0)[1] = b.at(2, 0)[1] = infinite;     // alike
    a.at(2, 0)[2] = -(b.at(2, 0)[2] = infinite);  // not alike
    a.at(3, 0)[0] = 1.5F;
    const ImageDifference d = compareImages(a, b);
    EXPECT_EQ(d.nonFinite.inImage, 4U);
    EXPECT_EQ(d.nonFinite.inReference, 4U);
    EXPECT_EQ(d.nonFinite.differing, 3U);
    EXPECT_EQ(d.values, 7U);
    EXPECT_DOUBLE_EQ(d.meanAbsolute, 1.0 / 7);
    EXPECT_EQ(d.maximum, infinite) << "no threshold lets it pass";
    EXPECT_EQ(d.x, 0U);
}

TEST(CompareImages, WithoutAnyFiniteValueTheMeansAreNotNumbers) {
    const Image a = constant(2, 1, 3, std::numeric_limits<float>::quiet_NaN());
    const ImageDifference d = compareImages(a, a);
    EXPECT_TRUE(std::isnan(d.meanAbsolute));
    EXPECT_EQ(d.values, 0U);
    EXPECT_EQ(d.nonFinite.differing, 0U);
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
