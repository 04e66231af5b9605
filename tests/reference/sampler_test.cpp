// Sampler bits against literal values, published sequences and the uniformity every sampler owes.
#include "reference/sampler.h"

#include <gmock/gmock.h>

#include <boost/random/sobol.hpp>
#include <set>

#include "reference/material.h"
#include "reference/samplers/bits.h"
#include "reference/samplers/sobol.h"
#include "statistics.h"

namespace vkpt::reference {
namespace {

constexpr std::uint32_t pack(std::uint32_t x, std::uint32_t y) { return x | y << 16U; }

// Worked out with arbitrary-precision integers from the formulas of estimator.md.
TEST(Hash, EqualsWorkedValues) {
    EXPECT_EQ(hash({0, 0, 0, 0}), glm::uvec4(0x0f02f829U, 0x2d568769U, 0x32b0c43bU, 0xd32548eaU));
    EXPECT_EQ(hash({1, 2, 3, 4}), glm::uvec4(0x3622cd16U, 0xf11471d8U, 0xe1109b3fU, 0x02b94c2fU));
    EXPECT_EQ(hash(glm::uvec4(0xffffffffU)), glm::uvec4(0x974ed892U, 0xc015dc67U, 0x9f955760U, 0xa1bba208U));
}

TEST(Hash, AlphaKeyEqualsWorkedValue) {
    const std::uint32_t key = alphaKey({pack(3, 5), 7, 64, 11}, 2, kRayShadow);
    EXPECT_EQ(key, 0xdc51ab56U);
    EXPECT_EQ(hash({key, 0, 9, kSaltAlpha}).x, 0x2e02d641U);
}

TEST(ToUnit, IsExactAndNeverOne) {
    EXPECT_EQ(toUnit(0), 0.0F);
    EXPECT_EQ(toUnit(0xffU), 0.0F);
    EXPECT_EQ(toUnit(0x80000000U), 0.5F);
    EXPECT_EQ(toUnit(0xffffffffU), 1.0F - 0x1p-24F);
}

// By an independent program of estimator.md's formulas in arbitrary precision; sample 7 of 64, seed 11.
TEST(EverySampler, EqualsWorkedValues) {
    struct Case {
        SamplerChoice sampler;
        SampleId id;
        std::uint32_t dim, bits;
    };
    const SampleId id{pack(3, 5), 7, 64, 11};
    const Case cases[] = {
        {SamplerId::Random, id, 10, 0x870117feU},
        {SamplerId::Sobol, {pack(3, 5), 6, 64, 11}, 0, 0x9d637368U},
        {SamplerId::Jittered, id, 10, 0x70e022ffU},
        {SamplerId::Jittered, id, 11, 0xb1fae84aU},
        {SamplerId::Lhs, id, 10, 0x421c045fU},
        {SamplerId::Multijittered, id, 11, 0xb23f5d09U},
        {SamplerId::Cmj, id, 10, 0x721c045fU},
        {SamplerId::Orthogonal, {pack(3, 5), 7, 121, 11}, 10, 0x1ebc4e7aU},
        {SamplerId::Orthogonal, {pack(3, 5), 130, 121, 11}, 13, 0xfbca8b44U},
        {SamplerId::Halton, id, 10, 0x8db9f4e3U},
        {SamplerId::Halton, {pack(3, 5), 100, 128, 11}, 2, 0xac527e04U},  // 100 ends in two zeros in base 5
        {{SamplerId::Halton, ScrambleId::Digit}, id, 10, 0x94a0f430U},
        {{SamplerId::Halton, ScrambleId::None}, id, 10, 0x39ce739cU},
        {SamplerId::Sobol02, id, 10, 0xc8eb49ceU},
        {SamplerId::Sobol02, id, 11, 0x1d778304U},
        {SamplerId::Rank1, id, 2, 0x48d52480U},
        {SamplerId::Zsobol, id, 10, 0xc13cddd1U},
        {SamplerId::Zsobol, {pack(300, 7), 7, 32, 11}, 11, 0xde2e549fU},
    };
    for (const Case& c : cases) {
        EXPECT_EQ(samplerBits(c.sampler)(c.id, c.dim), c.bits) << samplerName(c.sampler.id) << ' ' << c.dim;
    }
}

TEST(OwenScramble, EqualsWorkedValues) {
    EXPECT_EQ(owenScramble(0, 0), 0U);
    EXPECT_EQ(owenScramble(0x80000000U, 0x12345678U), 0x87e32b06U);
    EXPECT_EQ(owenScramble(0xdeadbeefU, 0xcafebabeU), 0xfb54716eU);
}

// Nested: the order of the bits is kept, so equal prefixes stay equal prefixes and differ from where they differed.
TEST(OwenScramble, KeepsTheLengthOfCommonPrefixes) {
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const glm::uvec4 h = hash({i, 1, 2, 3});
        const std::uint32_t a = owenScramble(h.x, h.z), b = owenScramble(h.y, h.z);
        EXPECT_EQ(std::countl_zero(a ^ b), std::countl_zero(h.x ^ h.y));
    }
}

// Boost walks the sequence in Gray code order, beginning with point 1.
TEST(SobolPoint, EqualsBoost) {
    constexpr std::size_t kDims = 300;
    boost::random::sobol engine(kDims);
    const double scale = std::ldexp(1.0, -64);
    for (std::uint32_t n = 1; n < 64; ++n) {
        const std::uint32_t index = n ^ (n >> 1U);
        for (std::uint32_t d = 0; d < kDims; ++d) {
            const double expected = static_cast<double>(engine()) * scale;
            ASSERT_NEAR(sobolPoint(index, d) * 0x1p-32, expected, 0x1p-31) << "point " << n << " dimension " << d;
        }
    }
}

TEST(SobolPoint, FirstDimensionIsVanDerCorput) {
    EXPECT_EQ(sobolPoint(1, 0), 0x80000000U);
    EXPECT_EQ(sobolPoint(6, 0), 0x60000000U);
    EXPECT_EQ(sobolPoint(0, 5), 0U);
}

// Every dimension is a (0,1)-sequence: any aligned block of 2^k points has one in each interval of 2^-k. Scrambled.
TEST(SobolSampler, StratifiesEveryDimension) {
    for (const std::uint32_t dim : {0U, 1U, 2U, 9U, 24U, 100U, 3666U, 3667U, 5000U}) {
        for (const std::uint32_t block : {0U, 3U}) {
            std::set<std::uint32_t> cells;
            for (std::uint32_t i = 0; i < 256; ++i) {
                cells.insert(samplerBits(SamplerId::Sobol)({pack(17, 40), block * 256 + i, 256, 5}, dim) >> 24U);
            }
            EXPECT_EQ(cells.size(), 256U) << "dimension " << dim << " block " << block;
        }
    }
}

// Dimensions 0 and 1 are a (0,2)-sequence: 256 points fill every elementary box of area 2^-8 once, scrambled or not.
TEST(SobolSampler, FirstTwoDimensionsFillElementaryBoxes) {
    for (std::uint32_t split = 0; split <= 8; ++split) {
        std::set<std::uint32_t> boxes;
        for (std::uint32_t i = 0; i < 256; ++i) {
            const SampleId id{pack(2, 3), i, 256, 9};
            const auto prefix = [&](std::uint32_t dim, std::uint32_t bits) {
                return static_cast<std::uint32_t>(std::uint64_t{samplerBits(SamplerId::Sobol)(id, dim)} >> (32 - bits));
            };
            boxes.insert(prefix(0, split) << (8 - split) | prefix(1, 8 - split));
        }
        EXPECT_EQ(boxes.size(), 256U) << split;
    }
}

class RegisteredSampler : public testing::TestWithParam<SamplerInfo> {};

// Over a square of neighbouring pixels and four seeds: pairs of dimensions, as a bounce uses them. Weak keys show here
// as stripes. The square is one of the blue-noise mask, which repeats beyond it.
TEST_P(RegisteredSampler, IsUniformOverPixelsAndSeeds) {
    const SamplerBits bits = samplerBits(GetParam().id);
    constexpr std::size_t kCells = 64;
    constexpr std::uint32_t kDraws = 65536;
    const std::uint32_t spp = sampleCount(GetParam().id, 16);
    for (const std::uint32_t dim : {0U, 1U, 10U, 29U, 4000U}) {
        std::vector<double> counts(kCells * kCells), expected(kCells * kCells, double{kDraws} / (kCells * kCells));
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const SampleId id{pack(i & 127U, i >> 7U & 127U), 3, spp, i >> 14U};
            counts[(bits(id, dim) >> 26U) * kCells + (bits(id, dim + 1) >> 26U)] += 1;
        }
        EXPECT_LT(test::chiSquareDeviate(counts, expected), 4) << "dimension " << dim;
    }
}

TEST_P(RegisteredSampler, ChangesWithPixelIndexSeedAndDimension) {
    const SamplerBits bits = samplerBits(GetParam().id);
    const std::uint32_t first = bits({pack(5, 6), 7, 64, 8}, 9);
    EXPECT_EQ(first, bits({pack(5, 6), 7, 64, 8}, 9));
    EXPECT_NE(first, bits({pack(6, 6), 7, 64, 8}, 9));
    EXPECT_NE(first, bits({pack(5, 7), 7, 64, 8}, 9));
    EXPECT_NE(first, bits({pack(5, 6), 8, 64, 8}, 9));
    EXPECT_NE(first, bits({pack(5, 6), 7, 64, 9}, 9));
    EXPECT_NE(first, bits({pack(5, 6), 7, 64, 8}, 10));
}

INSTANTIATE_TEST_SUITE_P(Registry, RegisteredSampler, testing::ValuesIn(kSamplers),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace vkpt::reference
