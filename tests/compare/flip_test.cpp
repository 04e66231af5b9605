#include "compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/flip_color.h"
#include "compare/flip_filters.h"
#include "test_images.h"

namespace vkpt {
namespace {

Image uniform(std::uint32_t width, std::uint32_t height, const glm::vec3& color) {
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = color[static_cast<int>(i % 3)];
    return image;
}

Image scaled(Image image, float factor) {
    for (float& v : image.pixels) v *= factor;
    return image;
}

double ldrMean(const glm::vec3& a, const glm::vec3& r) { return ldrFlip(uniform(7, 5, a), uniform(7, 5, r)).mean; }

double median(std::vector<float> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// Of floats. It is not smaller since the root of what the detectors leave of a constant is taken.
constexpr double kRounding = 6e-5;

// Uniform images have no features and pass the filters unchanged: what is left is HyAB^0.7, redistributed. The largest,
// of green and blue, is 203.3017^0.7 = 41.27610, so the knee lies at 16.51044.
//   black, white: HyAB = 100, 100^0.7 = 25.11886, 0.95 + 0.05 (25.11886 - 16.51044) / 24.76566 = 0.9673798
//   sRGB 0.02 on black: L* = 903.296 x 0.02 / 12.92 = 1.398291, 1.398291^0.7 = 1.264479, x 0.95 / 16.51044 = 0.0727584
// The other values come from the same formulas evaluated in double precision apart from this code.
TEST(Flip, OfUniformColoursFollowsFromTheFormulas) {
    EXPECT_NEAR(ldrMean({0, 0, 0}, {1, 1, 1}), 0.9673797618, kRounding);
    EXPECT_NEAR(ldrMean({0, 1, 0}, {0, 0, 1}), 1, kRounding);
    EXPECT_NEAR(ldrMean({0.02F, 0.02F, 0.02F}, {0, 0, 0}), 0.0727584392, kRounding);
    EXPECT_NEAR(ldrMean({0.2F, 0.2F, 0.2F}, {0.25F, 0.25F, 0.25F}), 0.1954345128, kRounding);
    EXPECT_NEAR(ldrMean({0.5F, 0.5F, 0.5F}, {0.6F, 0.5F, 0.5F}), 0.2496043990, kRounding);
    EXPECT_NEAR(ldrMean({1, 0, 0}, {0, 1, 1}), 0.9799065027, kRounding);
}

TEST(Flip, OfEqualImagesIsZeroAndItIsSymmetric) {
    const Image a = noise(40, 30, 3, 1), b = noise(40, 30, 3, 2);
    EXPECT_EQ(ldrFlip(a, a).mean, 0);
    EXPECT_EQ(ldrFlip(a, b).mean, ldrFlip(b, a).mean);
    EXPECT_GT(ldrFlip(a, b).mean, 0.05);
}

// Beside an edge from black to white the edge detector, whose one half sums to 1, answers 1; against black the point
// detector cannot answer more. So the feature difference is sqrt(1/sqrt 2), the colour one that of the blurred edge:
// a white pixel at the edge sees itself and half of what remains.
TEST(Flip, BesideAnEdgeFollowsFromTheFilters) {
    Image edge = uniform(64, 48, {0, 0, 0});
    for (std::uint32_t y = 0; y < 48; ++y)
        for (std::uint32_t x = 32; x < 64; ++x) std::fill_n(edge.at(x, y), 3, 1.0F);
    const FlipResult result = ldrFlip(edge, uniform(64, 48, {0, 0, 0}));
    const double pixels = kFlipPixelsPerDegree, spread = 0.0047;
    double sum = 0;
    for (int i = -10; i <= 10; ++i) sum += std::exp(-std::pow(std::numbers::pi * i / pixels, 2) / spread);
    const double light = (1 + 1 / sum) / 2, lightness = 116 * std::cbrt(light) - 16;
    const double knee = 0.4 * std::pow(203.30165461, 0.7), raised = std::pow(lightness, 0.7);
    const double color = 0.95 + (raised - knee) / (1.5 * knee) * 0.05;
    EXPECT_NEAR(*result.map.at(32, 24), std::pow(color, 1 - std::sqrt(std::sqrt(0.5))), kRounding);
    EXPECT_NEAR(*result.map.at(63, 24), 0.9673797618, kRounding) << "far from the edge: white on black";
    EXPECT_EQ(*result.map.at(0, 24), 0);
}

TEST(Flip, FiltersSumToWhatTheyShould) {
    const FlipFilters f = makeFlipFilters(kFlipPixelsPerDegree);
    const auto sum = [](const std::vector<float>& v, int sign) {
        double s = 0;
        for (const float w : v) s += w * static_cast<float>(sign) >= 0 || sign == 0 ? w : 0.0F;
        return s;
    };
    EXPECT_NEAR(sum(f.y, 0), 1, 1e-6);
    EXPECT_NEAR(sum(f.cx, 0), 1, 1e-6);
    EXPECT_NEAR(std::pow(sum(f.czNarrow, 0), 2) + std::pow(sum(f.czWide, 0), 2), 1, 1e-6);
    EXPECT_NEAR(sum(f.gauss, 0), 1, 1e-6);
    for (const auto* detector : {&f.edge, &f.point}) {
        EXPECT_NEAR(sum(*detector, 1), 1, 1e-6);
        EXPECT_NEAR(sum(*detector, -1), -1, 1e-6);
    }
    EXPECT_EQ(f.edge.size(), 19U) << "3 x 0.041 degrees to each side";
    EXPECT_EQ(f.czWide.size(), 21U);
}

TEST(Flip, CubeRootIsAccurate) {
    for (float x = 1e-3F; x < 2; x *= 1.0007F) ASSERT_NEAR(cubeRoot(x) / std::cbrt(double{x}), 1, 3e-7) << x;
}

TEST(Flip, GreyImagesOfOneChannelAreAsThoseOfThree) {
    Image a = noise(50, 40, 3, 1), b = noise(50, 40, 3, 2), greyA(50, 40, 1), greyB(50, 40, 1);
    for (std::size_t i = 0; i < greyA.pixels.size(); ++i) {
        a.pixels[3 * i + 1] = a.pixels[3 * i + 2] = greyA.pixels[i] = a.pixels[3 * i];
        b.pixels[3 * i + 1] = b.pixels[3 * i + 2] = greyB.pixels[i] = b.pixels[3 * i];
    }
    EXPECT_NEAR(ldrFlip(greyA, greyB).mean, ldrFlip(a, b).mean, 1e-5);
    EXPECT_NEAR(hdrFlip(greyA, greyB, {-1, 2, 3}).mean, hdrFlip(a, b, {-1, 2, 3}).mean, 1e-5);
}

// What a pixel shows depends on its surroundings only, not on where the image is cut for the threads.
TEST(Flip, DoesNotDependOnTheTiles) {
    const Image patch = noise(60, 50, 3, 3);
    const auto placed = [&](std::uint32_t x0, std::uint32_t y0) {
        Image image = uniform(600, 300, {0.5F, 0.5F, 0.5F});
        for (std::uint32_t y = 0; y < 50; ++y) std::copy_n(patch.at(0, y), 180, image.at(x0, y0 + y));
        return ldrFlip(image, uniform(600, 300, {0.5F, 0.5F, 0.5F})).map;
    };
    const Image inside = placed(50, 40), across = placed(225, 105);
    for (std::uint32_t y = 0; y < 100; ++y)
        for (std::uint32_t x = 0; x < 110; ++x)
            ASSERT_EQ(*inside.at(25 + x, 15 + y), *across.at(200 + x, 80 + y)) << x << ' ' << y;
}

// aces(x) = 0.85 at x = 2.118872; a uniform reference of 3 is seen there at log2(2.118872 / 3) = -0.5016658 EV, twice
// as much light as aces(4.237745) = 0.9396736. 0.1447528: the formulas in double precision, apart from this code.
TEST(HdrFlip, OfUniformImagesFollowsFromTheFormulas) {
    const Image reference = uniform(5, 5, {3, 3, 3});
    const FlipExposures exposures = flipExposures(reference);
    EXPECT_NEAR(exposures.start, -0.5016658, 1e-6);
    EXPECT_NEAR(exposures.stop, -0.5016658, 1e-6);
    EXPECT_EQ(exposures.count, 2U);
    EXPECT_NEAR(hdrFlip(uniform(5, 5, {6, 6, 6}), reference, exposures).mean, 0.1447527575, kRounding);
}

TEST(HdrFlip, ExposuresRunFromTheBrightestToTheMedian) {
    const Image reference = noise(31, 31, 3, 4);
    std::vector<float> luminances;
    for (std::size_t i = 0; i < reference.pixels.size(); i += 3)
        luminances.push_back(0.2126F * reference.pixels[i] + 0.7152F * reference.pixels[i + 1] +
                             0.0722F * reference.pixels[i + 2]);
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    const FlipExposures e = flipExposures(reference);
    EXPECT_NEAR(e.stop - e.start, std::log2(largest / median(luminances)), 1e-5);
    EXPECT_EQ(e.count, 2U);
    EXPECT_NEAR(std::exp2(e.start) * largest, 2.118872, 1e-5);
}

TEST(HdrFlip, ScalingBothImagesShiftsTheExposuresOnly) {
    const Image a = noise(40, 30, 3, 1), r = noise(40, 30, 3, 2);
    const FlipExposures e = flipExposures(r), shifted = flipExposures(scaled(r, 1024));
    EXPECT_NEAR(e.start - shifted.start, 10, 1e-6);
    EXPECT_NEAR(hdrFlip(a, r, e).mean, hdrFlip(scaled(a, 1024), scaled(r, 1024), shifted).mean, kRounding);
}

TEST(HdrFlip, BlackReferencesHaveExposuresToo) {
    EXPECT_EQ(flipExposures(uniform(4, 4, {0, 0, 0})).count, 1U);
    Image mostlyBlack = uniform(10, 10, {0, 0, 0});
    std::fill_n(mostlyBlack.pixels.begin(), 3, 8.0F);
    std::fill_n(mostlyBlack.pixels.begin() + 3, 3, 1.0F);
    std::fill_n(mostlyBlack.pixels.begin() + 6, 3, 1.0F);
    const FlipExposures e = flipExposures(mostlyBlack);
    EXPECT_NEAR(e.stop - e.start, 3, 1e-5) << "the median of what is not black is 1";
    std::fill_n(mostlyBlack.pixels.begin(), 3, 1e9F);
    std::fill_n(mostlyBlack.pixels.begin() + 3, 6, 1e-9F);
    EXPECT_EQ(flipExposures(mostlyBlack).count, 20U);
    EXPECT_TRUE(std::isfinite(hdrFlip(scaled(mostlyBlack, 2), mostlyBlack, flipExposures(mostlyBlack)).mean));
}

}  // namespace
}  // namespace vkpt
