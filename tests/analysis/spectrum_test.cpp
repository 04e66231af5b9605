// Spectra: of what is known, of blue noise, and of the error over the screen.
#include "analysis/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/integrands.h"
#include "dimensions.h"
#include "reference/sampler.h"
#include "scene/sampler_data.h"

namespace vkpt {
namespace {

TEST(PointSpectrum, OfRandomPointsIsFlat) {
    std::vector<Spectrum> spectra;
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        spectra.push_back(pointSpectrum(samplePoints(SamplerId::Random, 128, {0, 1}, seed), 16));
    const auto radial = meanSpectrum(spectra).radialMean();
    for (std::size_t f = 3; f < radial.size(); ++f) EXPECT_NEAR(radial[f], 1, 0.2) << f;
}

TEST(PointSpectrum, OfAGridIsItsPeaks) {
    PointSet grid{2, {}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) grid.values.insert(grid.values.end(), {x / 8.0, y / 8.0});
    const Spectrum s = pointSpectrum(grid, 8);
    EXPECT_NEAR(s.at(8, 0), 64, 1e-9);
    EXPECT_NEAR(s.at(-8, 8), 64, 1e-9);
    EXPECT_NEAR(s.at(3, 5), 0, 1e-9);
}

// Poisson disk sets: nothing below a third of the frequency of their spacing, random beyond; no two points too near.
TEST(PoissonDisk, KeepsItsDistanceAndHasAnEmptyLowBand) {
    std::vector<Spectrum> spectra;
    double points = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const PointSet p = poissonDisk(400, seed);
        points += static_cast<double>(p.size()) / 8;
        double nearest = 1;
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double x = p.at(i, 0) - p.at(j, 0), y = p.at(i, 1) - p.at(j, 1);
                nearest = std::min(nearest, std::hypot(x - std::round(x), y - std::round(y)));
            }
        EXPECT_GE(nearest, poissonDiskRadius(400));
        spectra.push_back(pointSpectrum(p, 60));
    }
    EXPECT_NEAR(points, 400, 40);
    const auto radial = meanSpectrum(spectra).radialMean();
    for (std::size_t f = 0; f < 8; ++f) EXPECT_LT(radial[f], 0.12) << f + 1;
    EXPECT_GT(*std::max_element(radial.begin(), radial.end()), 1.2) << "a peak at the spacing";
    EXPECT_NEAR(radial[58], 1, 0.2);
}

Image maskImage() {
    Image image(kMaskSide, kMaskSide, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<float>(blueNoiseMask()[i]) / static_cast<float>(image.pixels.size());
    return image;
}

TEST(ImageSpectrum, OfACosineIsOnePeak) {
    Image image(32, 32, 1);
    for (std::uint32_t y = 0; y < 32; ++y)
        for (std::uint32_t x = 0; x < 32; ++x)
            *image.at(x, y) = static_cast<float>(3 + std::cos(2 * std::numbers::pi * (3 * x + 2 * y) / 32));
    const Spectrum s = imageSpectrum(image, 0);
    EXPECT_NEAR(s.at(3, 2), 32 * 32 / 4.0, 1e-3);
    EXPECT_NEAR(s.at(-3, -2), 32 * 32 / 4.0, 1e-3);
    EXPECT_NEAR(s.at(3, -2), 0, 1e-3);
    EXPECT_NEAR(s.at(0, 0), 0, 1e-3);
}

// [Ulichney 93]: the mask, and each pattern of its lowest ranks, lack low frequencies.
TEST(BlueNoiseMask, HasAnEmptyLowBand) {
    const double area = std::numbers::pi * 16 * 16 / (128.0 * 128.0);  // share of white noise
    EXPECT_LT(imageSpectrum(maskImage(), 0).share(16), 0.05 * area);
    for (const double level : {0.1, 0.3, 0.5, 0.8}) {
        Image pattern = maskImage();
        for (float& v : pattern.pixels) v = v < level ? 1.0F : 0.0F;
        EXPECT_LT(imageSpectrum(pattern, 0).share(8), 0.15 * area / 4) << level;
    }
}

/// Over 128^2 pixels, the error of `spp` samples of a smooth integrand in the dimensions of a light sample.
Image errorImage(SamplerChoice sampler, std::uint32_t spp, std::uint32_t seed) {
    const auto bits = reference::samplerBits(sampler);
    constexpr std::uint32_t kDimension = kDimBounce + kDimLight;
    const Integrand& f = integrandNamed("gaussian");
    Image image(128, 128, 1);
    for (std::uint32_t y = 0; y < 128; ++y)
        for (std::uint32_t x = 0; x < 128; ++x) {
            double sum = 0;
            for (std::uint32_t i = 0; i < spp; ++i) {
                const reference::SampleId id{x | y << 16U, i, spp, seed};
                const double u[] = {bits(id, kDimension) * 0x1p-32, bits(id, kDimension + 1) * 0x1p-32};
                sum += f.value(u) / spp;
            }
            *image.at(x, y) = static_cast<float>(sum - f.integral);
        }
    return image;
}

class ScreenSpaceError : public testing::TestWithParam<std::tuple<SamplerId, std::uint32_t>> {};

// The error power below a quarter of Nyquist, of equal totals, is at most half of random's.
TEST_P(ScreenSpaceError, LacksLowFrequencies) {
    const auto [sampler, spp] = GetParam();
    double share = 0, random = 0;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        share += imageSpectrum(errorImage(sampler, spp, seed), 0).share(16) / 4;
        random += imageSpectrum(errorImage(SamplerId::Random, spp, seed), 0).share(16) / 4;
    }
    EXPECT_LT(share, 0.5 * random);
}

INSTANTIATE_TEST_SUITE_P(Samplers, ScreenSpaceError,
                         testing::Combine(testing::Values(SamplerId::Zsobol, SamplerId::Bluenoise),
                                          testing::Values(1U, 4U)),
                         [](const auto& p) {
                             return std::string(samplerName(std::get<0>(p.param))) +
                                    std::to_string(std::get<1>(p.param));
                         });

/// All but those that spread error over the screen by design.
std::vector<SamplerInfo> samplersOfPixels() {
    std::vector<SamplerInfo> samplers;
    for (const SamplerInfo& sampler : kSamplers)
        if (sampler.id != SamplerId::Zsobol && sampler.id != SamplerId::Bluenoise) samplers.push_back(sampler);
    return samplers;
}

// No correlation between pixels: the error is white.
class PixelsAreIndependent : public testing::TestWithParam<SamplerInfo> {};

TEST_P(PixelsAreIndependent, OfEachOther) {
    const std::uint32_t spp = sampleCount(GetParam().id, 4);
    const Spectrum s = imageSpectrum(errorImage(GetParam().id, spp, 3), 0);
    double low = 0, all = 0;
    for (int fy = -63; fy <= 63; ++fy)
        for (int fx = -63; fx <= 63; ++fx) {
            all += fx == 0 && fy == 0 ? 0 : 1;
            low += (fx != 0 || fy != 0) && fx * fx + fy * fy <= 256 ? 1 : 0;
        }
    EXPECT_NEAR(s.share(16) / (low / all), 1, 0.2);  // 800 frequencies, two by two alike: 5 % of spread
    const auto radial = s.radialMean();
    double mean = 0;
    for (const double p : radial) mean += p / static_cast<double>(radial.size());
    for (std::size_t f = 4; f < radial.size(); ++f) EXPECT_NEAR(radial[f] / mean, 1, 0.9) << "ring " << f + 1;
}

INSTANTIATE_TEST_SUITE_P(Registry, PixelsAreIndependent, testing::ValuesIn(samplersOfPixels()),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace vkpt
