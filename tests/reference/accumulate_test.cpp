// Fixed point: literal values, carries, refusals.
#include "reference/accumulate.h"

#include <gtest/gtest.h>

#include <limits>

namespace vkpt::reference {
namespace {

using Words = std::array<std::uint32_t, 3>;

TEST(ToFixedPoint, EqualsWorkedValues) {
    EXPECT_EQ(toFixedPoint(0.0F), (Words{0, 0, 0}));
    EXPECT_EQ(toFixedPoint(1.0F), (Words{0, 0x10000U, 0}));
    EXPECT_EQ(toFixedPoint(0.5F), (Words{0, 0x8000U, 0}));
    EXPECT_EQ(toFixedPoint(0x1.fffffep15F), (Words{0, 0xffffff00U, 0}));
    EXPECT_EQ(toFixedPoint(65536.0F), (Words{0, 0, 1}));
    EXPECT_EQ(toFixedPoint(0x1p-48F), (Words{1, 0, 0}));
    EXPECT_EQ(toFixedPoint(3 * 0x1p-33F), (Words{0x18000U, 0, 0}));
    EXPECT_EQ(toFixedPoint(0x1.fffffep39F), (Words{0, 0, 0x00ffffffU}));
}

TEST(ToFixedPoint, RoundsHalvesUpAndKeepsWhatIsBelowThemOut) {
    EXPECT_EQ(toFixedPoint(0x1p-49F), (Words{1, 0, 0}));
    EXPECT_EQ(toFixedPoint(0x1.fffffep-50F), (Words{0, 0, 0}));
    EXPECT_EQ(toFixedPoint(0x1.8p-48F), (Words{2, 0, 0}));
    EXPECT_EQ(toFixedPoint(0x1.7ffffep-48F), (Words{1, 0, 0}));
    EXPECT_EQ(toFixedPoint(std::numeric_limits<float>::denorm_min()), (Words{0, 0, 0}));
}

TEST(AddContribution, CarriesThroughAllWordsAndLeavesAlphaAlone) {
    FilmSums sums{};
    sums.red = {0xffffffffU, 0xffffffffU, 7, 42};
    ASSERT_TRUE(addContribution(sums, {0x1p-48F, 0, 2}, false));
    EXPECT_EQ(sums.red, uvec4(0, 0, 8, 42));
    EXPECT_EQ(sums.green, uvec4(0));
    EXPECT_EQ(sums.blue, uvec4(0, 0x20000U, 0, 0));
}

// A filter's lobes below 0 take away what they add, to the bit.
TEST(AddContribution, TakesAwayWhatIsBelowZero) {
    const float values[] = {0x1p-49F, 0x1p-48F, 0.7F, 1e-9F, 3e7F, 0x1.fffffep39F};
    for (const float value : values) {
        FilmSums sums{};
        sums.blue = {5, 6, 7, 42};
        ASSERT_TRUE(addContribution(sums, {-value, 0, value}, true));
        EXPECT_NE(sums.red, uvec4(0));
        EXPECT_FALSE(pathLuminance(sums)) << value;
        ASSERT_TRUE(addContribution(sums, {value, 0, -value}, true));
        EXPECT_EQ(sums.red, uvec4(0)) << value;
        EXPECT_EQ(sums.blue, uvec4(5, 6, 7, 42)) << value;
    }
}

void expectRefused(float value, bool mayTakeAway) {
    for (int channel = 0; channel < 3; ++channel) {
        FilmSums sums{};
        vec3 contribution(1);
        contribution[channel] = value;
        EXPECT_FALSE(addContribution(sums, contribution, mayTakeAway)) << value;
        EXPECT_EQ(sums.red + sums.green + sums.blue, uvec4(0));
    }
}

TEST(AddContribution, RefusesWholeWhatIsNotARadiance) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    for (const float value : {std::numeric_limits<float>::quiet_NaN(), kInfinity, -kInfinity, 0x1p40F, -0x1p40F})
        for (const bool mayTakeAway : {false, true}) expectRefused(value, mayTakeAway);
    for (const float value : {-1e-20F, -1.0F, -std::numeric_limits<float>::denorm_min()}) expectRefused(value, false);
}

}  // namespace
}  // namespace vkpt::reference
