#include "scene/sobol_directions.h"

#include <gtest/gtest.h>

#include <boost/random/sobol.hpp>

#include "constants.h"

namespace vkpt {
namespace {

std::uint32_t sobolBits(const std::vector<std::uint32_t>& directions, std::uint32_t index, std::size_t dimension) {
    std::uint32_t bits = 0;
    for (unsigned k = 0; k < 32; ++k) bits ^= (index >> k & 1U) != 0 ? directions[dimension * 32 + k] : 0U;
    return bits;
}

// new-joe-kuo-6.21201, first lines: s, a, m of dimensions 2 to 5, as printed in [Joe 08].
TEST(SobolDirections, BeginAsPublished) {
    const auto v = sobolDirections();
    ASSERT_EQ(v.size(), std::size_t{kSobolDimensions} * 32);
    const std::vector<std::vector<std::uint32_t>> initial{{}, {1}, {1, 3}, {1, 3, 1}, {1, 1, 1}, {1, 1, 3, 3}};
    for (std::size_t d = 1; d < initial.size(); ++d) {
        for (std::size_t k = 0; k < initial[d].size(); ++k)
            EXPECT_EQ(v[d * 32 + k], initial[d][k] << (31 - k)) << d << ' ' << k;
    }
}

TEST(SobolDirections, FirstPointsAreThePublishedOnes) {
    const auto v = sobolDirections();
    // Index order, not Gray code: 0, 1/2, 1/4, 3/4 and their partners.
    const double expected[8][3] = {{0, 0, 0},
                                   {0.5, 0.5, 0.5},
                                   {0.25, 0.75, 0.75},
                                   {0.75, 0.25, 0.25},
                                   {0.125, 0.625, 0.375},
                                   {0.625, 0.125, 0.875},
                                   {0.375, 0.375, 0.625},
                                   {0.875, 0.875, 0.125}};
    for (std::uint32_t i = 0; i < 8; ++i) {
        for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(sobolBits(v, i, d) * 0x1p-32, expected[i][d]) << i << ' ' << d;
    }
}

TEST(SobolDirections, EqualBoostsEngineInGrayCodeOrder) {
    const auto v = sobolDirections();
    boost::random::sobol_engine<std::uint32_t, 32> engine(kSobolDimensions);  // leaves out point 0
    for (std::uint32_t i = 1; i < 300; ++i) {
        const std::uint32_t gray = i ^ i >> 1U;
        for (std::size_t d = 0; d < kSobolDimensions; ++d) ASSERT_EQ(engine(), sobolBits(v, gray, d)) << i << ' ' << d;
    }
}

TEST(SobolDirections, EveryDimensionIsAPermutationOfEveryPowerOfTwo) {
    const auto v = sobolDirections();
    for (std::size_t d = 0; d < kSobolDimensions; ++d) {
        // Upper triangular with a unit diagonal: bit k contributes 2^-(k+1) and nothing finer.
        for (unsigned k = 0; k < 32; ++k) {
            ASSERT_NE(v[d * 32 + k] & (1U << (31 - k)), 0U) << d << ' ' << k;
            ASSERT_EQ(v[d * 32 + k] & ((1U << (31 - k)) - 1U), 0U) << d << ' ' << k;
        }
    }
}

}  // namespace
}  // namespace vkpt
