// Discrepancies against published closed forms, against brute force, and against random points' expectation.
#include "analysis/discrepancy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt {
namespace {

PointSet hammersley(std::uint32_t m) {
    return samplePoints({SamplerId::Hammersley, ScrambleId::None}, 1U << m, {0, 1}, 0);
}
PointSet halton(std::uint32_t n, const std::vector<std::uint32_t>& dims = {0, 1}) {
    return samplePoints({SamplerId::Halton, ScrambleId::None}, n, dims, 0);
}

// Exact star discrepancy of the Hammersley set of 2^m points in base 2, m >= 2. [De Clerck 86]
TEST(StarDiscrepancy, OfHammersleyIsThePublishedOne) {
    for (std::uint32_t m = 2; m <= 11; ++m) {
        const double n = std::ldexp(1.0, static_cast<int>(m));
        const double expected = (m / 3.0 + 13.0 / 9 - (m % 2 == 0 ? 1 : -1) * 4 / (9 * n)) / n;
        EXPECT_NEAR(starDiscrepancy(hammersley(m)).value, expected, 1e-9) << m;
    }
}

// Exact L2 star discrepancy of the same sets. [Vilenkin 67, Halton 69]
TEST(L2Star, OfHammersleyIsThePublishedOne) {
    for (std::uint32_t m = 1; m <= 9; ++m) {
        const double n = std::ldexp(1.0, static_cast<int>(m)), k = m;
        const double square = k * k / 64 + 29 * k / 192 + 3.0 / 8 - k / (16 * n) + 1 / (4 * n) - 1 / (72 * n * n);
        EXPECT_NEAR(l2Star(hammersley(m)), std::sqrt(square) / n, 1e-8) << m;
    }
}

/// The supremum by trying every corner, open and closed.
double bruteStar(const PointSet& p) {
    double worst = 0;
    for (std::size_t i = 0; i <= p.size(); ++i)
        for (std::size_t j = 0; j <= p.size(); ++j) {
            const double x = i < p.size() ? p.at(i, 0) : 1, y = j < p.size() ? p.at(j, 1) : 1;
            double open = 0, closed = 0;
            for (std::size_t k = 0; k < p.size(); ++k) {
                open += p.at(k, 0) < x && p.at(k, 1) < y ? 1 : 0;
                closed += p.at(k, 0) <= x && p.at(k, 1) <= y ? 1 : 0;
            }
            const auto n = static_cast<double>(p.size());
            worst = std::max({worst, closed / n - x * y, x * y - open / n});
        }
    return worst;
}

TEST(StarDiscrepancy, EqualsBruteForce) {
    for (std::uint32_t n = 1; n < 40; ++n) {
        EXPECT_DOUBLE_EQ(starDiscrepancy(halton(n)).value, bruteStar(halton(n))) << n;
        const PointSet random = samplePoints(SamplerId::Random, n, {0, 1}, n);
        const StarDiscrepancy star = starDiscrepancy(random);
        EXPECT_DOUBLE_EQ(star.value, bruteStar(random)) << n;
        EXPECT_NEAR(star.value, std::abs(star.x * star.y - static_cast<double>(star.inside) / n), 1e-12) << "the box";
    }
}

// The lecture's figure: a box of area 0.09 that holds one of four samples; 0.25 - 0.09 = 0.16, the worst of these.
TEST(StarDiscrepancy, OfTheLecturesFourSamples) {
    const StarDiscrepancy star = starDiscrepancy({2, {0.3, 0.3, 0.4, 0.75, 0.75, 0.4, 0.8, 0.8}});
    EXPECT_NEAR(star.value, bruteStar({2, {0.3, 0.3, 0.4, 0.75, 0.75, 0.4, 0.8, 0.8}}), 1e-12);
    EXPECT_GE(star.value, 0.25 - 0.3 * 0.3);
}

/// Integral of the squared local discrepancy over anchored boxes, on a fine grid.
TEST(L2Star, EqualsTheIntegralItStandsFor) {
    const PointSet p = samplePoints(SamplerId::Random, 7, {0, 1}, 3);
    constexpr int kSteps = 700;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double x = (i + 0.5) / kSteps, y = (j + 0.5) / kSteps;
            double inside = 0;
            for (std::size_t k = 0; k < p.size(); ++k) inside += p.at(k, 0) < x && p.at(k, 1) < y ? 1 : 0;
            sum += std::pow(inside / 7 - x * y, 2);
        }
    EXPECT_NEAR(l2Star(p), std::sqrt(sum) / kSteps, 1e-3);
}

// One point in the middle, in closed form. [Hickernell 98]
TEST(L2Discrepancies, OfOnePointAreThePublishedFormulas) {
    const PointSet middle{1, {0.5}};
    EXPECT_NEAR(l2Centred(middle), std::sqrt(13.0 / 12 - 2 + 1), 1e-12);
    EXPECT_NEAR(l2Wrapped(middle), std::sqrt(3.0 / 2 - 4.0 / 3), 1e-12);
    EXPECT_NEAR(l2Star(middle), std::sqrt(1.0 / 3 - 2 * 0.375 + 0.5), 1e-12);
}

TEST(L2Discrepancies, OfRandomPointsAreExpectedToBeThat) {
    constexpr int kSets = 400;
    for (const std::size_t dims : {1U, 2U, 5U}) {
        std::vector<std::uint32_t> dimensions;
        for (std::uint32_t d = 0; d < dims; ++d) dimensions.push_back(d);
        double star = 0, centred = 0, wrapped = 0;
        for (std::uint32_t seed = 0; seed < kSets; ++seed) {
            const PointSet p = samplePoints(SamplerId::Random, 16, dimensions, seed);
            star += std::pow(l2Star(p), 2) / kSets;
            centred += std::pow(l2Centred(p), 2) / kSets;
            wrapped += std::pow(l2Wrapped(p), 2) / kSets;
        }
        EXPECT_NEAR(std::sqrt(star) / randomL2Star(16, dims), 1, 0.08);
        EXPECT_NEAR(std::sqrt(centred) / randomL2Centred(16, dims), 1, 0.08);
        EXPECT_NEAR(std::sqrt(wrapped) / randomL2Wrapped(16, dims), 1, 0.08);
    }
}

// Of N random points it falls with the root of N; root(N) times it is about 1.3 in the plane.
TEST(StarDiscrepancy, OfRandomPointsFallsWithTheRoot) {
    EXPECT_NEAR(randomStar(64) * 8, 1.3, 0.25);
    EXPECT_NEAR(randomStar(1024) * 32, 1.3, 0.25);
}

TEST(StarDiscrepancy, HammersleyBelowHaltonBelowJitteredBelowRandom) {
    const auto mean = [](SamplerChoice sampler) {
        double sum = 0;
        for (std::uint32_t seed = 0; seed < 20; ++seed)
            sum += starDiscrepancy(samplePoints(sampler, 256, {0, 1}, seed)).value / 20;
        return sum;
    };
    EXPECT_LT(mean({SamplerId::Hammersley, ScrambleId::None}), mean({SamplerId::Halton, ScrambleId::None}));
    EXPECT_LT(mean(SamplerId::Halton), mean(SamplerId::Jittered));
    EXPECT_LT(mean(SamplerId::Jittered), mean(SamplerId::Random));
}

}  // namespace
}  // namespace vkpt
