#include "scene/sampling_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

double steps(float value) { return double{value} * 16777216.0; }

TEST(SamplingTable, ValuesAreMultiplesOfTheSamplersStepAndEndAtOne) {
    std::vector<double> weights;
    for (int i = 0; i < 1000; ++i) weights.push_back(std::pow(1.02, i));
    const std::vector<float> cdf = inclusiveCdf(weights);
    for (const float value : cdf) EXPECT_EQ(steps(value), std::floor(steps(value)));
    EXPECT_TRUE(std::is_sorted(cdf.begin(), cdf.end()));
    EXPECT_EQ(cdf.back(), 1.0F);
}

TEST(SamplingTable, ProbabilitiesAreProportionalToWeights) {
    const std::vector<double> weights{1, 2, 3, 4};
    const std::vector<float> cdf = inclusiveCdf(weights);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(cdfStep(cdf, i), weights[i] / 10, 3e-7);
}

TEST(SamplingTable, CountingAllUniformNumbersGivesThePmfExactly) {
    const std::vector<double> weights{1e-12, 5, 0, 0.3, 1e-30, 2, 0};
    const std::vector<float> cdf = inclusiveCdf(weights);
    std::vector<std::uint64_t> counts(weights.size());
    for (std::uint32_t k = 0; k < (1U << 24U); ++k) {
        const float u = static_cast<float>(k) * 0x1p-24F;
        std::size_t i = 0;
        while (u >= cdf[i]) ++i;
        ++counts[i];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_EQ(static_cast<double>(counts[i]), steps(cdfStep(cdf, i))) << i;
        EXPECT_EQ(counts[i] > 0, weights[i] > 0) << i;
    }
}

TEST(SamplingTable, TheLastPositiveWeightReachesOneBeforeTrailingZeros) {
    const std::vector<float> cdf = inclusiveCdf(std::vector<double>{0.1, 0.7, 0, 0});
    EXPECT_LT(cdf[0], 1.0F);
    EXPECT_EQ(cdf[1], 1.0F);
    EXPECT_EQ(cdf[3], 1.0F);
}

TEST(SamplingTable, ZeroWeightsCountAsEqual) {
    const std::vector<float> cdf = inclusiveCdf(std::vector<double>(4, 0.0));
    EXPECT_EQ(cdf, (std::vector<float>{0.25F, 0.5F, 0.75F, 1.0F}));
    EXPECT_TRUE(inclusiveCdf({}).empty());
}

}  // namespace
}  // namespace vkpt
