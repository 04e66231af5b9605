// Finite stratified sets: what each promises of its cells, rows and columns, over many seeds and sizes.
#include "reference/samplers/strata.h"

#include <gtest/gtest.h>

#include "reference/samplers/points.h"
#include "scene/primes.h"

namespace vkpt::reference {
namespace {

using test::cellsHit;
using test::coordinates;
using test::partsHit;

constexpr std::uint32_t kSeeds = 50;

TEST(Permute, EqualsWorkedValues) {  // of [Kensler 13]'s listing, in arbitrary precision
    const std::uint32_t expected[] = {6, 8, 10, 5, 2, 9, 3, 0, 4, 1, 7};
    for (std::uint32_t i = 0; i < 11; ++i) EXPECT_EQ(permute(i, 11, 0x12345678U), expected[i]);
    EXPECT_EQ(permute(5, 64, 0xdeadbeefU), 20U);
    EXPECT_EQ(permute(99, 1000, 7), 932U);
}

TEST(Permute, IsAPermutationOfEveryLength) {
    for (std::uint32_t n = 1; n <= 130; ++n) {
        std::set<std::uint32_t> images;
        for (std::uint32_t i = 0; i < n; ++i) images.insert(permute(i, n, n * 0x9e3779b9U));
        EXPECT_EQ(images.size(), n);
        EXPECT_EQ(*images.rbegin(), n - 1);
    }
}

TEST(StrataGrid, HoldsTheSamplesWithFewCellsToSpare) {
    for (std::uint32_t spp = 1; spp < 3000; ++spp) {
        const StrataGrid grid(spp);
        ASSERT_GE(grid.size(), spp);
        ASSERT_LT(grid.size(), spp + grid.columns);
        ASSERT_LE(grid.rows - grid.columns, 2U);
        ASSERT_EQ(sampleCount(SamplerId::Jittered, spp), grid.size()) << "what --spp is rounded to";
        ASSERT_EQ(StrataGrid(grid.size()).size(), grid.size()) << "a rounded number stays";
    }
    EXPECT_EQ(StrataGrid(65536).size(), 65536U);
    EXPECT_EQ(StrataGrid(1U << 31U).size(), 65536U);
}

/// Grid samplers with the pairs that a camera and two bounces use.
class GridSampler : public testing::TestWithParam<SamplerId> {
protected:
    template <class Check>
    void forEachSet(const Check& check) const {
        for (const std::uint32_t wanted : {1U, 2U, 4U, 7U, 16U, 64U, 90U, 256U}) {
            const std::uint32_t spp = sampleCount(GetParam(), wanted);
            for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
                for (const std::uint32_t dim : {0U, 4U, 10U})
                    check(StrataGrid(spp), coordinates(GetParam(), dim, spp, seed),
                          coordinates(GetParam(), dim + 1, spp, seed));
        }
    }
};

TEST_P(GridSampler, PutsOneSampleInEveryStratum) {
    forEachSet([](const StrataGrid& grid, const auto& x, const auto& y) {
        ASSERT_EQ(cellsHit(x, y, grid.columns, grid.rows), grid.size());
    });
}

TEST_P(GridSampler, BeginsAnotherSetBeyondTheCount) {
    const auto x = coordinates(GetParam(), 2, 64, 128, 64, 5), y = coordinates(GetParam(), 3, 64, 128, 64, 5);
    EXPECT_EQ(cellsHit(x, y, 8, 8), 64U);
    EXPECT_NE(x, coordinates(GetParam(), 2, 0, 64, 64, 5));
}

INSTANTIATE_TEST_SUITE_P(Samplers, GridSampler,
                         testing::Values(SamplerId::Jittered, SamplerId::Multijittered, SamplerId::Cmj),
                         [](const auto& p) { return std::string(samplerName(p.param)); });

class MultiJittered : public GridSampler {};

TEST_P(MultiJittered, PutsOneSampleInEveryRowAndColumn) {
    forEachSet([](const StrataGrid& grid, const auto& x, const auto& y) {
        ASSERT_EQ(partsHit(x, grid.size()), grid.size());
        ASSERT_EQ(partsHit(y, grid.size()), grid.size());
    });
}

/// For each cell of an 8 x 8 grid, in which of 8 fine columns of its column the sample lies.
std::vector<std::vector<std::uint32_t>> fineColumns(SamplerId sampler, std::uint32_t seed) {
    std::vector<std::vector<std::uint32_t>> fine(8, std::vector<std::uint32_t>(8));
    const auto x = coordinates(sampler, 0, 64, seed), y = coordinates(sampler, 1, 64, seed);
    for (std::size_t i = 0; i < 64; ++i) fine[test::part(x[i], 8)][test::part(y[i], 8)] = test::part(x[i], 64) % 8;
    return fine;
}

TEST(Cmj, ShufflesAllColumnsAlikeAndMultiJitteredEachAnew) {
    int alike = 0;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const auto correlated = fineColumns(SamplerId::Cmj, seed), free = fineColumns(SamplerId::Multijittered, seed);
        for (std::size_t column = 1; column < 8; ++column) {
            EXPECT_EQ(correlated[column], correlated[0]);
            alike += free[column] == free[0] ? 1 : 0;
        }
    }
    EXPECT_LE(alike, 1);
}

INSTANTIATE_TEST_SUITE_P(Samplers, MultiJittered, testing::Values(SamplerId::Multijittered, SamplerId::Cmj),
                         [](const auto& p) { return std::string(samplerName(p.param)); });

TEST(LatinHypercube, PutsOneSampleInEveryRowOfEveryDimension) {
    for (const std::uint32_t spp : {1U, 2U, 3U, 10U, 64U, 97U, 1000U})
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
            for (const std::uint32_t dim : {0U, 1U, 10U, 143U})
                ASSERT_EQ(partsHit(coordinates(SamplerId::Lhs, dim, spp, seed), spp), spp);
}

TEST(Orthogonal, RoundsToTheSquareOfAPrime) {
    EXPECT_EQ(sampleCount(SamplerId::Orthogonal, 1), 4U);
    EXPECT_EQ(sampleCount(SamplerId::Orthogonal, 64), 121U);
    EXPECT_EQ(sampleCount(SamplerId::Orthogonal, 121), 121U);
    EXPECT_EQ(sampleCount(SamplerId::Orthogonal, 62002), 63001U);
    EXPECT_EQ(sampleCount(SamplerId::Orthogonal, 63002), 126002U);
}

// Strength 2: any two of an array's p + 1 dimensions hold every pair of levels once.
TEST(Orthogonal, JittersEveryPairOfDimensionsOfAnArray) {
    for (const std::uint32_t p : {3U, 5U, 7U, 11U}) {
        for (std::uint32_t seed = 0; seed < 10; ++seed) {
            for (const std::uint32_t array : {0U, 1U, 5U}) {
                std::vector<std::vector<std::uint32_t>> points;
                for (std::uint32_t j = 0; j <= p; ++j)
                    points.push_back(coordinates(SamplerId::Orthogonal, array * (p + 1) + j, p * p, seed));
                for (std::uint32_t a = 0; a <= p; ++a) {
                    ASSERT_EQ(partsHit(points[a], p * p), p * p) << "one a row, of all dimensions";
                    for (std::uint32_t b = 0; b < a; ++b) ASSERT_EQ(cellsHit(points[a], points[b], p, p), p * p);
                }
            }
        }
    }
}

// Of dimensions in two arrays, a cell is empty as often as 11 of 121 rows drawn at random miss 11 given ones.
TEST(Orthogonal, ShufflesItsArraysIndependently) {
    constexpr std::uint32_t kP = 11;
    double cells = 0, empty = 1;
    for (int i = 0; i < 11; ++i) empty *= (110.0 - i) / (121.0 - i);
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        cells += static_cast<double>(cellsHit(coordinates(SamplerId::Orthogonal, 0, kP * kP, seed),
                                              coordinates(SamplerId::Orthogonal, 12, kP * kP, seed), kP, kP));
    EXPECT_NEAR(cells / 40, kP * kP * (1 - empty), 2);
}

TEST(Orthogonal, OfFourSamplesHasPairs) {
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
        EXPECT_EQ(cellsHit(coordinates(SamplerId::Orthogonal, 4, 4, seed),
                           coordinates(SamplerId::Orthogonal, 5, 4, seed), 2, 2),
                  4U);
}

}  // namespace
}  // namespace vkpt::reference
