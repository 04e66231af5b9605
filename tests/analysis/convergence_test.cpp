// Every randomised sampler is unbiased; variance falls with the slope theory gives. [Mitchell 96, Owen 97]
#include "analysis/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt {
namespace {

TEST(Integrands, HaveTheirIntegrals) {
    for (const Integrand& f : kIntegrands) {
        const Estimates e = estimate({SamplerId::Sobol, ScrambleId::Owen}, f, 4096, 16, 1);
        EXPECT_NEAR(e.meanError, 0, 2e-3) << f.name;
    }
}

std::vector<SamplerChoice> randomised() {
    std::vector<SamplerChoice> choices;
    for (const SamplerChoice& choice : allSamplerChoices())
        if (choice.isRandomised()) choices.push_back(choice);
    return choices;
}

std::string nameOf(const testing::TestParamInfo<SamplerChoice>& p) {
    return std::string(samplerName(p.param.id)) + "_" + std::string(scrambleName(p.param.scramble));
}

class Randomised : public testing::TestWithParam<SamplerChoice> {};

/// A z-test of the mean over pixels and seeds; 4.5 is passed once in 150,000 by chance.
void expectUnbiased(SamplerChoice sampler, std::uint32_t trials) {
    for (const Integrand& f : kIntegrands)
        for (const std::uint32_t wanted : {1U, 4U, 16U, 60U}) {
            const Estimates e = estimate(sampler, f, sampleCount(sampler.id, wanted), trials, 100);
            EXPECT_LT(std::abs(e.meanError), 4.5 * e.standardError + 1e-9) << f.name << ' ' << e.count;
        }
}

TEST_P(Randomised, IsUnbiased) { expectUnbiased(GetParam(), 400); }
TEST_P(Randomised, IsUnbiasedFull) { expectUnbiased(GetParam(), 20000); }

INSTANTIATE_TEST_SUITE_P(Registry, Randomised, testing::ValuesIn(randomised()), nameOf);

struct Claim {
    SamplerChoice sampler;
    const char* integrand;
    double least, most;  ///< of the slope of log variance
};

class Slope : public testing::TestWithParam<Claim> {};

const std::vector<Claim> kClaims{
    {SamplerId::Random, "gaussian", -1.1, -0.9},
    {SamplerId::Random, "product8", -1.1, -0.9},
    {SamplerId::Jittered, "gaussian", -2.15, -1.85},
    {SamplerId::Jittered, "bilinear", -2.15, -1.85},
    {SamplerId::Jittered, "disc", -1.65, -1.35},
    {SamplerId::Cmj, "gaussian", -1.8, -1.3},  // one shuffle for all columns: root N independent terms of N
    {SamplerId::Multijittered, "gaussian", -3.3, -1.9},
    {{SamplerId::Sobol, ScrambleId::Owen}, "gaussian", -3.5, -2.5},
    {{SamplerId::Sobol, ScrambleId::Owen}, "bilinear", -3.5, -2.5},
    {{SamplerId::Sobol, ScrambleId::Owen}, "disc", -1.75, -1.3},
    {SamplerId::Sobol02, "gaussian", -3.5, -2.5},
    {SamplerId::Pmj02, "gaussian", -3.5, -2.5},
    {SamplerId::Pmj02, "disc", -1.75, -1.3},
    {{SamplerId::Halton, ScrambleId::Owen}, "gaussian", -3.5, -2},
    {SamplerId::Lhs, "product4", -1.15, -0.85},
    {SamplerId::Lhs, "disc", -1.15, -0.85},
    {SamplerId::Lhs, "additive4", -3.2, -2.6},
    {SamplerId::Sobol02, "product4", -1.35, -0.85},
    {SamplerId::Jittered, "product4", -1.35, -0.85},
    {SamplerId::Pmj02, "product4", -1.35, -0.85},  // its pairs must not share an order
    {SamplerId::Pmj02, "product8", -1.35, -0.85},
    {{SamplerId::Sobol, ScrambleId::Owen}, "product4", -3.5, -1.8},
};

void expectSlope(const Claim& claim, std::uint32_t trials, std::uint32_t least, std::uint32_t most) {
    std::vector<std::uint32_t> counts;
    for (std::uint32_t n = least; n <= most; n *= 4) counts.push_back(n);
    const Convergence c = convergence(claim.sampler, integrandNamed(claim.integrand), counts, trials, 7);
    EXPECT_GT(c.slope, claim.least);
    EXPECT_LT(c.slope, claim.most);
}

TEST_P(Slope, IsWhatTheorySays) { expectSlope(GetParam(), 150, 16, 1024); }
TEST_P(Slope, IsWhatTheorySaysFull) { expectSlope(GetParam(), 1000, 16, 4096); }

INSTANTIATE_TEST_SUITE_P(Claims, Slope, testing::ValuesIn(kClaims), [](const auto& p) {
    return std::string(samplerName(p.param.sampler.id)) + "_" + p.param.integrand;
});

// Orthogonal arrays stratify all pairs: the pairwise part of a 4D integrand goes, which padded pairs keep.
TEST(Orthogonal, BeatsPaddedPairsOnProducts) {
    const Integrand& f = integrandNamed("product4");
    const double padded = estimate(SamplerId::Cmj, f, 529, 300, 1).variance;
    EXPECT_LT(estimate(SamplerId::Orthogonal, f, 529, 300, 1).variance, padded / 2);
}

}  // namespace
}  // namespace vkpt
