#include "film/tonemap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt {
namespace {

void expectNear(glm::vec3 actual, glm::dvec3 expected, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

TEST(EveryToneMap, MapsRadianceIntoTheUnitCubeAndKeepsGreysGrey) {
    for (const ToneMapInfo& map : kToneMaps) {
        SCOPED_TRACE(map.name);
        float previous = -1;
        for (float v = 0; v < 1e6F; v = v * 1.25F + 1e-4F) {
            const glm::vec3 grey = toneMap(map.id, glm::vec3(v));
            EXPECT_GE(grey.x, 0);
            EXPECT_LE(grey.x, 1);
            expectNear(grey, glm::dvec3(grey.x), 1e-3);  // the rows of the published matrices sum to about 1
            EXPECT_GE(grey.x, previous - 1e-4F) << "not monotone at " << v;
            previous = grey.x;
            for (const glm::vec3 tint : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0.1F), glm::vec3(0.2F, 0, 1)}) {
                const glm::vec3 color = toneMap(map.id, v * tint);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_GE(color[c], 0);
                    EXPECT_LE(color[c], 1);
                }
            }
        }
    }
}

// The specification: below compression the mapper only takes 4 % off, and less of it near black.
TEST(NeutralToneMap, ValuesOfTheSpecification) {
    expectNear(toneMap(ToneMap::Neutral, {0.5F, 0.3F, 0.1F}), {0.46, 0.26, 0.06}, 1e-6);
    expectNear(toneMap(ToneMap::Neutral, {0.5F, 0.3F, 0.04F}), {0.47, 0.27, 0.01}, 1e-6);
    // Input 1: p = 0.96, pn = 1 - 0.24^2 / (0.96 + 1 - 1.52) = 0.869090..., g only desaturates and this is grey.
    expectNear(toneMap(ToneMap::Neutral, glm::vec3(1)), glm::dvec3(1 - 0.0576 / 0.44), 1e-6);
    // A saturated red: f = 0, p = 2, pn = 0.961081..., g = 1 / (0.15 (p - pn) + 1).
    const double pn = 1 - 0.0576 / 1.48, g = 1 / (0.15 * (2 - pn) + 1);
    expectNear(toneMap(ToneMap::Neutral, {2, 0, 0}), {pn, pn * (1 - g), pn * (1 - g)}, 1e-6);
}

TEST(NeutralToneMap, BaseColourOfAMirroringWhiteSurfaceReturns) {
    // A dielectric of base colour c under white light shows c + 0.04; the mapper gives c back. [Khronos 24]
    for (const float c : {0.1F, 0.4F, 0.7F}) EXPECT_NEAR(toneMap(ToneMap::Neutral, glm::vec3(c + 0.04F)).x, c, 1e-6);
}

// Evaluated by hand in double precision from the published constants.
TEST(AcesToneMap, MiddleGreyAndRed) {
    const auto curve = [](double v) {
        return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
    };
    // Rows of both matrices sum to one up to their printing: greys pass through the curve alone.
    expectNear(toneMap(ToneMap::Aces, glm::vec3(0.18F)), glm::dvec3(curve(0.3)), 1e-4);
    const double r = curve(0.59719), gr = curve(0.07600), b = curve(0.02840);
    expectNear(toneMap(ToneMap::Aces, {0.6F, 0, 0}),
               {1.60475 * r - 0.53108 * gr - 0.07367 * b, std::max(0.0, -0.10208 * r + 1.10813 * gr - 0.00605 * b),
                std::max(0.0, -0.00327 * r - 0.07276 * gr + 1.07602 * b)},
               1e-5);
}

TEST(AgxToneMap, GreysFollowTheContrastPolynomial) {
    for (const double v : {0.01, 0.18, 1.0, 8.0}) {
        const double x = (std::log2(v) + 12.47393) / (4.026069 + 12.47393);
        const double contrast =
            -0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5)))));
        expectNear(toneMap(ToneMap::Agx, glm::vec3(static_cast<float>(v))), glm::dvec3(std::pow(contrast, 2.2)), 1e-3);
    }
}

TEST(AgxToneMap, BrightPrimariesGoToWhite) {
    const glm::vec3 dim = toneMap(ToneMap::Agx, {0.5F, 0, 0}), bright = toneMap(ToneMap::Agx, {1000, 0, 0});
    EXPECT_LT(dim.y, 0.15F * dim.x);
    EXPECT_GT(bright.y, 0.5F);
}

TEST(SrgbEncode, FollowsTheStandard) {
    EXPECT_EQ(srgbEncode(0), 0);
    EXPECT_NEAR(srgbEncode(1), 1, 1e-6);
    EXPECT_FLOAT_EQ(srgbEncode(0.002F), 0.02584F);
    EXPECT_NEAR(srgbEncode(0.214041F), 0.5, 1e-5);
    EXPECT_NEAR(srgbEncode(0.0031308F), srgbEncode(0.0031309F), 1e-5);
    EXPECT_EQ(srgbEncode(-1), 0);
}

TEST(DisplayImage, ExposureIsInStops) {
    Image linear(1, 1, 4);
    linear.pixels = {0.1F, 0.1F, 0.1F, 1};
    const Image shown = displayImage(linear, {.toneMap = ToneMap::None, .exposure = 2});
    ASSERT_EQ(shown.channels, 3U);
    EXPECT_FLOAT_EQ(shown.pixels[0], srgbEncode(0.4F));
}

// Where a pixel filter has lobes below 0 a picture may, too: a screen shows black.
TEST(DisplayImage, WhatIsBelowZeroIsBlackUnderEveryToneMap) {
    Image image(1, 1, 4);
    image.pixels = {-0.5F, -1e-3F, -40, 1};
    for (const ToneMapInfo& map : kToneMaps) {
        Image black(1, 1, 4);
        black.pixels[3] = 1;
        EXPECT_EQ(displayImage(image, {map.id, 0, false}).pixels, displayImage(black, {map.id, 0, false}).pixels);
    }
}

TEST(DisplayImage, TransparentPixelsHaveTheirOwnColourAndStraightAlpha) {
    Image linear(2, 1, 4);
    linear.pixels = {0.1F, 0.05F, 0, 0.25F, 0, 0, 0, 0};
    const Image shown = displayImage(linear, {.toneMap = ToneMap::None, .transparent = true});
    ASSERT_EQ(shown.channels, 4U);
    EXPECT_FLOAT_EQ(shown.pixels[0], srgbEncode(0.4F));
    EXPECT_FLOAT_EQ(shown.pixels[1], srgbEncode(0.2F));
    EXPECT_EQ(shown.pixels[3], 0.25F);
    EXPECT_EQ(shown.pixels[7], 0);
}

}  // namespace
}  // namespace vkpt
