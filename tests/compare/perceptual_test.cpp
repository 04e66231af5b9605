#include "compare/perceptual.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "compare/ssim.h"
#include "film/tonemap.h"
#include "test_images.h"

namespace vkpt {
namespace {

Image displayed(Image image) {
    image.displayEncoded = true;
    return image;
}

Image channel(const Image& image, std::uint32_t c) {
    Image result(image.width, image.height, 1);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] = image.pixels[i * image.channels + c];
    return result;
}

TEST(Perceptual, DisplayImagesTakeLdrFlipAndLinearOnesHdrFlip) {
    const Image a = noise(32, 24, 3, 1), r = noise(32, 24, 3, 2);
    const PerceptualDifference display = comparePerceptually(displayed(a), displayed(r)),
                               linear = comparePerceptually(a, r);
    EXPECT_EQ(display.flip.mean, ldrFlip(a, r).mean);
    EXPECT_EQ(display.flipExposures.count, 1U);
    EXPECT_EQ(linear.flip.mean, hdrFlip(a, r, flipExposures(r)).mean);
    EXPECT_GT(linear.flipExposures.count, 1U);
}

TEST(Perceptual, SsimOfLinearImagesIsThatOfTheEncodedOnes) {
    const Image a = noise(32, 24, 3, 1, 3), r = noise(32, 24, 3, 2, 3);
    Image encodedA = displayed(a), encodedR = displayed(r);
    for (float& v : encodedA.pixels) v = srgbEncode(v);
    for (float& v : encodedR.pixels) v = srgbEncode(v);
    const PerceptualDifference linear = comparePerceptually(a, r), display = comparePerceptually(encodedA, encodedR);
    EXPECT_EQ(linear.ssim, display.ssim);
    for (std::uint32_t c = 0; c < 3; ++c) {
        EXPECT_EQ(linear.channels.at(c).ssim, ssim(channel(encodedA, c), channel(encodedR, c)));
        EXPECT_EQ(linear.channels.at(c).ssim, display.channels.at(c).ssim);
    }
}

TEST(Perceptual, FlipOfAChannelIsThatOfTheGreyImageAndOnlyOnRequest) {
    const Image a = displayed(noise(32, 24, 3, 1)), r = displayed(noise(32, 24, 3, 2));
    EXPECT_TRUE(std::isnan(comparePerceptually(a, r).channels.at(1).flip));
    const PerceptualDifference p = comparePerceptually(a, r, {.flipPerChannel = true});
    for (std::uint32_t c = 0; c < 3; ++c) EXPECT_EQ(p.channels.at(c).flip, ldrFlip(channel(a, c), channel(r, c)).mean);
}

TEST(Perceptual, AlphaIsNotLookedAtAndGreyHasNoChannels) {
    Image a = noise(32, 24, 4, 1);
    const Image r = a;
    for (std::size_t i = 3; i < a.pixels.size(); i += 4) a.pixels[i] = 0;
    EXPECT_EQ(comparePerceptually(a, r).flip.mean, 0);
    EXPECT_DOUBLE_EQ(comparePerceptually(a, r).ssim, 1);
    const PerceptualDifference grey = comparePerceptually(noise(32, 24, 1, 1), noise(32, 24, 1, 2));
    EXPECT_TRUE(grey.channels.empty());
    EXPECT_GT(grey.flip.mean, 0);
}

TEST(Perceptual, WhatIsNotFiniteIsBlackInBothAndSpoilsNothing) {
    Image a = noise(32, 24, 3, 1), r = noise(32, 24, 3, 2), blackA = a, blackR = r;
    a.at(5, 5)[1] = std::numeric_limits<float>::quiet_NaN();
    r.at(9, 9)[0] = std::numeric_limits<float>::infinity();
    for (const std::uint32_t i : {5U, 9U}) {
        std::fill_n(blackA.at(i, i), 3, 0.0F);
        std::fill_n(blackR.at(i, i), 3, 0.0F);
    }
    const PerceptualDifference p = comparePerceptually(a, r), expected = comparePerceptually(blackA, blackR);
    EXPECT_EQ(p.flip.mean, expected.flip.mean);
    EXPECT_EQ(p.ssim, expected.ssim);
    EXPECT_TRUE(std::isfinite(p.flip.mean + p.ssim));
}

TEST(Perceptual, NeverMixesDisplayAndLinearValues) {
    EXPECT_THROW((void)comparePerceptually(displayed(noise(32, 24, 3, 1)), noise(32, 24, 3, 2)), Error);
}

}  // namespace
}  // namespace vkpt
