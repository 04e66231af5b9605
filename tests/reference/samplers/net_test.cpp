// Sequences in base 2: (t,m,s)-nets before and after scrambling, tables, lattices, and what holds over the screen.
#include <gtest/gtest.h>

#include <bit>

#include "reference/samplers/net02.h"
#include "reference/samplers/points.h"
#include "reference/samplers/sobol.h"
#include "scene/sampler_data.h"

namespace vkpt::reference {
namespace {

using test::coordinates;
using test::fillEvenly;
using Points = std::vector<std::vector<std::uint32_t>>;

constexpr std::uint32_t pixelAt(std::uint32_t x, std::uint32_t y) { return x | y << 16U; }

/// Whether 2^m points fill every elementary box of 2^-(m-t) evenly: a (t,m,s)-net in base 2.
bool isNet(const Points& points, unsigned m, unsigned t, std::vector<std::uint64_t> grid = {}, unsigned used = 0) {
    if (grid.size() + 1 == points.size()) {
        grid.push_back(1ULL << (m - t - used));
        return fillEvenly(points, grid);
    }
    for (unsigned k = 0; used + k <= m - t; ++k) {
        auto next = grid;
        next.push_back(1ULL << k);
        if (!isNet(points, m, t, next, used + k)) return false;
    }
    return true;
}

Points pointsOf(SamplerChoice sampler, const std::vector<std::uint32_t>& dims, std::uint32_t begin, std::uint32_t end,
                std::uint32_t seed, std::uint32_t spp = 4096) {
    Points points;
    for (const std::uint32_t dim : dims) points.push_back(coordinates(sampler, dim, begin, end, spp, seed));
    return points;
}

class SobolScramble : public testing::TestWithParam<ScrambleId> {};

// t of the first s dimensions: the degrees of their primitive polynomials, less one each. [Joe 08]
TEST_P(SobolScramble, IsTheNetThatTSays) {
    const SamplerChoice sobol{SamplerId::Sobol, GetParam()};
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
        for (const std::uint32_t block : {0U, 3U}) {
            const auto net = [&](const std::vector<std::uint32_t>& dims, unsigned m, unsigned t) {
                return isNet(pointsOf(sobol, dims, block << m, (block + 1) << m, seed), m, t);
            };
            ASSERT_TRUE(net({0, 1}, 8, 0));
            ASSERT_TRUE(net({0, 1, 2}, 7, 1));
            ASSERT_TRUE(net({0, 1, 2, 3}, 7, 3));
            ASSERT_FALSE(net({0, 1, 2}, 7, 0)) << "the test can tell";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SobolScramble, testing::Values(ScrambleId::None, ScrambleId::Xor, ScrambleId::Owen),
                         [](const auto& p) { return std::string(scrambleName(p.param)); });

TEST(Net02, IsTheFirstTwoDimensionsOfSobol) {
    for (const std::uint32_t index : {0U, 1U, 2U, 3U, 100U, 4095U, 0x12345678U, 0xffffffffU})
        for (std::uint32_t axis = 0; axis < 2; ++axis) EXPECT_EQ(net02Point(index, axis), sobolPoint(index, axis));
}

TEST(Sobol02, EveryAlignedBlockOfEveryPairIsAZeroNet) {
    for (std::uint32_t seed = 0; seed < 10; ++seed)
        for (const std::uint32_t pair : {0U, 5U, 70U})
            for (const unsigned m : {1U, 2U, 4U, 6U, 8U})
                for (const std::uint32_t block : {0U, 1U, 5U})
                    ASSERT_TRUE(isNet(
                        pointsOf(SamplerId::Sobol02, {2 * pair, 2 * pair + 1}, block << m, (block + 1) << m, seed), m,
                        0));
}

// [Christensen 18]: every first 2^k points. Of the tables themselves and as they are sampled.
TEST(Pmj02, EveryFirstPowerOfTwoIsAZeroNet) {
    static_assert(kPmj02Tables >= 16 && kPmj02Points == 4096);
    for (std::uint32_t table = 0; table < kPmj02Tables; ++table) {
        Points points(2);
        for (std::uint32_t i = 0; i < kPmj02Points; ++i) {
            const std::uint32_t p = pmj02Tables()[table * kPmj02Points + i];
            points[0].push_back(p << 16U);
            points[1].push_back(p & 0xffff0000U);
        }
        ASSERT_TRUE(isNet(points, 12, 0)) << table;
    }
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        for (unsigned m = 1; m <= 8; ++m)
            for (const std::uint32_t dim : {0U, 10U, 40U})
                ASSERT_TRUE(isNet(pointsOf(SamplerId::Pmj02, {dim, dim + 1}, 0, 1U << m, seed), m, 0)) << m;
}

TEST(Pmj02, BeginsAFreshCopyBeyondATable) {
    const Points first = pointsOf(SamplerId::Pmj02, {0, 1}, 0, 256, 1),
                 second = pointsOf(SamplerId::Pmj02, {0, 1}, 4096, 4352, 1);
    EXPECT_NE(first, second);
    EXPECT_TRUE(isNet(second, 8, 0));
}

TEST(Pmj02, PairsOfAPathTakeDifferentTables) {
    // In one pixel, the cells that samples 0 to 15 visit in order, up to scrambling: how x prefixes coincide.
    const auto pattern = [](std::uint32_t dim) {
        std::vector<int> shared;
        const auto x = coordinates(SamplerId::Pmj02, dim, 64, 5);
        for (std::size_t i = 0; i < 64; ++i)
            for (std::size_t j = 0; j < i; ++j) shared.push_back(std::countl_zero(x[i] ^ x[j]));
        return shared;
    };
    std::set<std::vector<int>> patterns;
    for (const std::uint32_t pair : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 20U, 31U})
        patterns.insert(pattern(2 * pair));
    EXPECT_EQ(patterns.size(), 12U);
}

// Every aligned block of sobol02 is a net, tested above. The published algorithm promises that of first blocks only.
TEST(Pmj02, IsNotSobol02) {
    std::size_t nets = 0, blocks = 0;
    for (std::uint32_t seed = 0; seed < 20; ++seed)
        for (std::uint32_t block = 1; block < 16; ++block, ++blocks)
            nets += isNet(pointsOf(SamplerId::Pmj02, {0, 1}, 16 * block, 16 * (block + 1), seed), 4, 0) ? 1 : 0;
    EXPECT_LT(nets, blocks * 9 / 10);
}

// x_i = radical inverse of i times z, modulo 1, plus a shift: differences of points are differences of indices.
TEST(Rank1, IsAShiftedLattice) {
    const auto x = coordinates(SamplerId::Rank1, 3, 256, 9), y = coordinates(SamplerId::Rank1, 4, 256, 9);
    std::set<std::pair<std::uint32_t, std::uint32_t>> lattice;
    for (std::size_t i = 0; i < 256; ++i) lattice.insert({x[i] - x[0], y[i] - y[0]});
    ASSERT_EQ(lattice.size(), 256U);
    for (const auto& [ax, ay] : lattice)
        for (const auto& [bx, by] : lattice)
            ASSERT_TRUE(lattice.contains({ax + bx, ay + by})) << "closed under addition";
    EXPECT_EQ(kRank1Generator[1], 182667U);
    EXPECT_EQ(kRank1Generator[249], 480757U);
}

// Extensible: every first 2^k is equispaced in every dimension.
TEST(Rank1, EveryFirstPowerOfTwoIsEquispaced) {
    for (std::uint32_t dim = 0; dim < kRank1Dimensions; dim += 7)
        for (const unsigned m : {1U, 3U, 6U, 9U}) {
            auto x = coordinates(SamplerId::Rank1, dim, 1U << m, 4);
            for (std::size_t i = x.size(); i-- > 0;) x[i] -= x[0];
            std::sort(x.begin(), x.end());
            for (std::size_t i = 0; i < x.size(); ++i) ASSERT_EQ(x[i], static_cast<std::uint32_t>(i) << (32 - m));
        }
}

// [Ahmed 20]: the samples of every aligned block of 2^k x 2^k pixels are together one net.
TEST(Zsobol, SamplesOfAlignedPixelBlocksAreNets) {
    const SamplerBits bits = samplerBits(SamplerId::Zsobol);
    for (const std::uint32_t spp : {1U, 2U, 4U, 8U}) {
        for (const std::uint32_t side : {1U, 2U, 4U, 8U}) {
            for (const std::uint32_t dim : {0U, 10U, 14U}) {
                Points points(2);
                for (std::uint32_t y = 0; y < side; ++y)
                    for (std::uint32_t x = 0; x < side; ++x)
                        for (std::uint32_t i = 0; i < spp; ++i)
                            for (std::uint32_t axis = 0; axis < 2; ++axis)
                                points[axis].push_back(
                                    bits({pixelAt(5 * side + x, 9 * side + y), i, spp, 2}, dim + axis));
                const auto m = static_cast<unsigned>(std::countr_zero(side * side * spp));
                ASSERT_TRUE(isNet(points, m, 0)) << spp << ' ' << side << ' ' << dim;
            }
        }
    }
}

TEST(Bluenoise, MaskHoldsEveryRankOnce) {
    std::set<std::uint32_t> ranks(blueNoiseMask().begin(), blueNoiseMask().end());
    EXPECT_EQ(ranks.size(), kMaskSide * kMaskSide);
    EXPECT_EQ(*ranks.rbegin(), kMaskSide * kMaskSide - 1);
}

// One set for all pixels, shifted: differences between samples do not depend on the pixel.
TEST(Bluenoise, ShiftsOneSetAndCoversTheUnitIntervalOverTheMask) {
    const auto a = coordinates(SamplerId::Bluenoise, 10, 0, 64, 64, 3, pixelAt(1, 2)),
               b = coordinates(SamplerId::Bluenoise, 10, 0, 64, 64, 3, pixelAt(77, 40));
    for (std::size_t i = 1; i < 64; ++i) ASSERT_EQ(a[i] - a[0], b[i] - b[0]);
    std::vector<std::uint32_t> over;
    const SamplerBits bits = samplerBits(SamplerId::Bluenoise);
    const std::uint32_t first = a[0] - bits({pixelAt(1, 2), 0, 64, 3}, 10);
    EXPECT_EQ(first, 0U);
    for (std::uint32_t y = 0; y < kMaskSide; ++y)
        for (std::uint32_t x = 0; x < kMaskSide; ++x) over.push_back(bits({pixelAt(x, y), 0, 64, 3}, 10));
    std::sort(over.begin(), over.end());
    const double cell = 0x1p32 / over.size();
    for (std::size_t i = 0; i < over.size(); i += 97) EXPECT_NEAR(over[i], cell * static_cast<double>(i), 1.5 * cell);
}

}  // namespace
}  // namespace vkpt::reference
