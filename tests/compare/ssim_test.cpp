#include "compare/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test_images.h"

namespace vkpt {
namespace {

Image constant(std::uint32_t width, std::uint32_t height, float value) {
    Image image(width, height, 1);
    for (float& v : image.pixels) v = value;
    return image;
}

/// SSIM of the window whose top left pixel is (x0, y0), from its definition: weighted moments about the means.
double ssimOfWindow(const Image& a, const Image& r, std::uint32_t x0, std::uint32_t y0) {
    double weights = 0, meanA = 0, meanR = 0;
    const auto forEach = [&](const auto& function) {
        for (std::uint32_t y = 0; y < 11; ++y)
            for (std::uint32_t x = 0; x < 11; ++x) {
                const double dx = x - 5.0, dy = y - 5.0;
                function(std::exp(-(dx * dx + dy * dy) / 4.5), *a.at(x0 + x, y0 + y), *r.at(x0 + x, y0 + y));
            }
    };
    forEach([&](double w, double va, double vr) { weights += w, meanA += w * va, meanR += w * vr; });
    meanA /= weights, meanR /= weights;
    double varianceA = 0, varianceR = 0, covariance = 0;
    forEach([&](double w, double va, double vr) {
        varianceA += w * (va - meanA) * (va - meanA) / weights;
        varianceR += w * (vr - meanR) * (vr - meanR) / weights;
        covariance += w * (va - meanA) * (vr - meanR) / weights;
    });
    return (2 * meanA * meanR + 1e-4) / (meanA * meanA + meanR * meanR + 1e-4) * (2 * covariance + 9e-4) /
           (varianceA + varianceR + 9e-4);
}

TEST(Ssim, IsOneOfEqualImages) { EXPECT_DOUBLE_EQ(ssim(noise(40, 30, 1, 1), noise(40, 30, 1, 1)), 1); }

TEST(Ssim, OfConstantsIsTheLuminanceTermAlone) {
    EXPECT_NEAR(ssim(constant(20, 20, 0.25F), constant(20, 20, 0.75F)), (2 * 0.25 * 0.75 + 1e-4) / (0.625 + 1e-4),
                1e-9);
    EXPECT_NEAR(ssim(constant(11, 11, 0), constant(11, 11, 1)), 1e-4 / (1 + 1e-4), 1e-9);
}

// Larger than a tile in both directions, so the seams are in it.
TEST(Ssim, IsTheMeanOverAllWindows) {
    const Image a = noise(280, 150, 1, 1);
    Image r = noise(280, 150, 1, 2);
    for (std::size_t i = 0; i < r.pixels.size(); ++i) r.pixels[i] = (3 * a.pixels[i] + r.pixels[i]) / 4;
    double sum = 0;
    for (std::uint32_t y = 0; y + 11 <= 150; ++y)
        for (std::uint32_t x = 0; x + 11 <= 280; ++x) sum += ssimOfWindow(a, r, x, y);
    const double expected = sum / (270.0 * 140.0);
    EXPECT_NEAR(ssim(a, r), expected, 1e-12);
    EXPECT_LT(expected, 0.97) << "the images do differ";
}

TEST(Ssim, WithoutRoomForAWindowThereIsNone) {
    EXPECT_TRUE(std::isnan(ssim(constant(10, 100, 1), constant(10, 100, 1))));
    EXPECT_TRUE(std::isnan(ssim(constant(100, 10, 1), constant(100, 10, 1))));
}

}  // namespace
}  // namespace vkpt
