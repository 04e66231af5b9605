// Halton and Hammersley: published points and permutations, and elementary intervals under every scramble.
#include <gmock/gmock.h>

#include "reference/samplers/points.h"
#include "reference/samplers/radical_inverse.h"
#include "reference/statistics.h"
#include "scene/primes.h"
#include "scene/sampler_table.h"

namespace vkpt::reference {
namespace {

using test::coordinates;
using testing::ElementsAre;

double value(SamplerChoice sampler, std::uint32_t index, std::uint32_t dim, std::uint32_t spp = 64) {
    return samplerBits(sampler)({0, index, spp, 0}, dim) * 0x1p-32;
}

const SamplerChoice kPlain{SamplerId::Halton, ScrambleId::None};

// The first points in bases 2, 3 and 5 as [Halton 60] and every textbook has them.
TEST(Halton, FirstPointsAreThePublishedOnes) {
    const double expected[][3] = {{0, 0, 0},
                                  {1 / 2., 1 / 3., 1 / 5.},
                                  {1 / 4., 2 / 3., 2 / 5.},
                                  {3 / 4., 1 / 9., 3 / 5.},
                                  {1 / 8., 4 / 9., 4 / 5.},
                                  {5 / 8., 7 / 9., 1 / 25.},
                                  {3 / 8., 2 / 9., 6 / 25.},
                                  {7 / 8., 5 / 9., 11 / 25.},
                                  {1 / 16., 8 / 9., 16 / 25.}};
    for (std::uint32_t i = 0; i < 9; ++i)
        for (std::uint32_t d = 0; d < 3; ++d)
            EXPECT_NEAR(value(kPlain, i, d), expected[i][d], 0x1p-31) << i << ' ' << d;
}

TEST(Halton, UsesThePrimesInOrder) {
    const auto primes = firstPrimes(kHaltonDimensions);
    EXPECT_EQ(primes.front(), 2U);
    EXPECT_EQ(primes.back(), 1619U);
    for (std::uint32_t d = 0; d < kHaltonDimensions; ++d) ASSERT_NEAR(value(kPlain, 1, d), 1.0 / primes[d], 0x1p-31);
}

TEST(Hammersley, IsIOverNAndThenHalton) {
    const SamplerChoice plain{SamplerId::Hammersley, ScrambleId::None};
    for (const std::uint32_t n : {1U, 3U, 64U, 1000U, 1U << 31U}) {
        EXPECT_NEAR(value(plain, n - 1, 0, n), (n - 1.0) / n, 0x1p-31);
        EXPECT_EQ(value(plain, n / 2, 3, n), value(kPlain, n / 2, 2, n));
    }
}

// [Faure 92], as tabulated for bases 2 to 8; here both makers of the permutation.
TEST(FaurePermutations, AreThePublishedOnes) {
    EXPECT_THAT(faurePermutation(2), ElementsAre(0, 1));
    EXPECT_THAT(faurePermutation(3), ElementsAre(0, 1, 2));
    EXPECT_THAT(faurePermutation(4), ElementsAre(0, 2, 1, 3));
    EXPECT_THAT(faurePermutation(5), ElementsAre(0, 3, 2, 1, 4));
    EXPECT_THAT(faurePermutation(6), ElementsAre(0, 2, 4, 1, 3, 5));
    EXPECT_THAT(faurePermutation(7), ElementsAre(0, 2, 5, 3, 1, 4, 6));
    EXPECT_THAT(faurePermutation(8), ElementsAre(0, 4, 2, 6, 1, 5, 3, 7));
    for (const std::uint32_t base : {2U, 3U, 5U, 7U, 11U, 97U, 1619U}) {
        const auto permutation = faurePermutation(base);
        for (std::uint32_t d = 0; d < base; ++d) ASSERT_EQ(faureDigit(d, base), permutation[d]) << base << ' ' << d;
        EXPECT_EQ(permutation[0], 0U);
    }
}

TEST(Faure, PermutesEveryDigit) {
    const SamplerChoice faure{SamplerId::Halton, ScrambleId::Faure};
    EXPECT_NEAR(value(faure, 1, 2), 3 / 5., 0x1p-31);
    EXPECT_NEAR(value(faure, 6, 2), 3 / 5. + 3 / 25., 0x1p-31);
    EXPECT_NEAR(value(faure, 23, 3), 5 / 7. + 3 / 49., 0x1p-31);  // 23 = 2 + 3 * 7
}

class HaltonScramble : public testing::TestWithParam<ScrambleId> {
protected:
    [[nodiscard]] static std::vector<std::vector<std::uint32_t>> points(std::uint32_t begin, std::uint32_t end,
                                                                        std::uint32_t seed, std::uint32_t dims) {
        std::vector<std::vector<std::uint32_t>> result;
        for (std::uint32_t d = 0; d < dims; ++d)
            result.push_back(coordinates({SamplerId::Halton, GetParam()}, d, begin, end, end, seed));
        return result;
    }
};

// 2^a 3^b points, aligned, fill each of the 2^a x 3^b boxes once.
TEST_P(HaltonScramble, FillsElementaryBoxes) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        for (const auto& [columns, rows] : {std::pair{2U, 3U}, {8U, 9U}, {16U, 3U}, {4U, 81U}}) {
            const std::uint32_t n = columns * rows;
            for (const std::uint32_t block : {0U, 5U})
                ASSERT_TRUE(test::fillEvenly(points(block * n, (block + 1) * n, seed, 2), {columns, rows}, 1));
        }
        ASSERT_TRUE(test::fillEvenly(points(0, 4 * 9 * 5, seed, 3), {4, 9, 5}, 1));
    }
}

TEST_P(HaltonScramble, StratifiesHighDimensions) {
    const auto primes = firstPrimes(kHaltonDimensions);
    for (const std::uint32_t dim : {9U, 30U, 142U, 255U}) {
        const std::uint32_t base = primes[dim];
        EXPECT_EQ(test::partsHit(coordinates({SamplerId::Halton, GetParam()}, dim, base, 3), base, 1), base);
    }
}

// Hammersley's set of 2^m points in (i/N, base 2) is a (0,m,2)-net.
TEST_P(HaltonScramble, HammersleyFillsElementaryBoxes) {
    const SamplerChoice sampler{SamplerId::Hammersley, GetParam()};
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const auto x = coordinates(sampler, 0, 256, seed), y = coordinates(sampler, 1, 256, seed);
        for (std::uint32_t a = 0; a <= 8; ++a) ASSERT_EQ(test::cellsHit(x, y, 1U << a, 256U >> a), 256U);
    }
}

TEST_P(HaltonScramble, DimensionsBeyondThePrimesDiffer) {
    const SamplerChoice sampler{SamplerId::Halton, GetParam()};
    EXPECT_NE(coordinates(sampler, 3, 64, 1), coordinates(sampler, 3 + kHaltonDimensions, 64, 1));
}

INSTANTIATE_TEST_SUITE_P(All, HaltonScramble,
                         testing::Values(ScrambleId::None, ScrambleId::Faure, ScrambleId::Digit, ScrambleId::Owen),
                         [](const auto& p) { return std::string(scrambleName(p.param)); });

/// Over many keys, how often the first digits of indices 1 and 4 in base 7 become each pair: a chi-square deviate.
double pairDeviate(ScrambleId scramble) {
    std::vector<double> counts(49), expected(49);
    constexpr int kKeys = 42000;
    for (std::uint32_t key = 0; key < kKeys; ++key) {
        const std::uint32_t mixed = hash({key, 1, 2, 3}).x;
        const std::uint32_t a = test::part(radicalInverse(1, 7, scramble, mixed), 7, 1);
        const std::uint32_t b = test::part(radicalInverse(4, 7, scramble, mixed), 7, 1);
        counts[a * 7 + b] += 1;
    }
    for (std::size_t i = 0; i < 49; ++i) expected[i] = i / 7 == i % 7 ? 0 : kKeys / 42.0;
    return vkpt::test::chiSquareDeviate(counts, expected);
}

// What the variance of scrambled nets rests on: any two digits go to any two others alike, and never to one.
TEST(OwenInBaseB, SendsPairsOfDigitsToAllPairsAlike) {
    EXPECT_LT(pairDeviate(ScrambleId::Owen), 4);
    EXPECT_LT(pairDeviate(ScrambleId::Digit), 4);
}

// Nested: the second digit's permutation depends on the first digit; by places: it does not.
TEST(OwenInBaseB, PermutesDigitsBelowDifferentDigitsIndependently) {
    const auto secondDigits = [](ScrambleId scramble, std::uint32_t first, std::uint32_t key) {
        std::vector<std::uint32_t> digits;
        for (std::uint32_t d = 0; d < 5; ++d)
            digits.push_back(test::part(radicalInverse(first + 5 * d, 5, scramble, key), 25, 1) % 5);
        return digits;
    };
    int same = 0;
    for (std::uint32_t key = 1; key <= 400; ++key) {
        EXPECT_EQ(secondDigits(ScrambleId::Digit, 1, key), secondDigits(ScrambleId::Digit, 3, key));
        same += secondDigits(ScrambleId::Owen, 1, key) == secondDigits(ScrambleId::Owen, 3, key) ? 1 : 0;
    }
    EXPECT_NEAR(same, 20, 18) << "one of 20 affine maps by chance";
}

}  // namespace
}  // namespace vkpt::reference
