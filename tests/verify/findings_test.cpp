#include "verify/findings.h"

#include <gtest/gtest.h>

#include <limits>

namespace vkpt {
namespace {

TEST(Findings, ToleranceIsTheSumOfAbsoluteAndRelative) {
    Findings f;
    EXPECT_TRUE(f.near("x", 10.5, 10.0, 0.25, 0.025));
    EXPECT_FALSE(f.near("x", 10.51, 10.0, 0.25, 0.025));
    EXPECT_FALSE(f.near("x", 9.49, 10.0, 0.25, 0.025));
    EXPECT_TRUE(f.near("x", 0.0, 0.0, 0.0)) << "equal values need no tolerance";
    EXPECT_EQ(f.quantities().size(), 1U);
    EXPECT_EQ(f.quantities()[0].compared, 4U);
    EXPECT_EQ(f.quantities()[0].outside, 2U);
    EXPECT_DOUBLE_EQ(f.worst(), 1);
}

TEST(Findings, WhatIsNotANumberIsNeverNear) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double wrong : {nan, inf, -inf}) {
        Findings f;
        EXPECT_FALSE(f.near("x", wrong, 1, 1e30, 1e30));
        EXPECT_FALSE(f.near("x", 1, nan, 1e30, 1e30));
        EXPECT_FALSE(f.near("v", glm::dvec2(1, wrong), glm::dvec2(1, 1), 1e30, 1e30));
        EXPECT_TRUE(f.disagreement());
    }
}

TEST(Findings, OneBadComponentIsEnough) {
    Findings f;
    EXPECT_TRUE(f.near("v", glm::vec3(1, 2, 3), glm::vec3(1, 2, 3), 0));
    EXPECT_FALSE(f.near("v", glm::vec3(1, 2, 3), glm::vec3(1, 2.1F, 3), 0.05));
    EXPECT_FALSE(f.equal("w", glm::uvec2(1, 2), glm::uvec2(1, 3)));
}

TEST(Findings, TheFirstDisagreementIsKeptWithItsInput) {
    Findings f;
    {
        const auto scope = f.inputs([](std::size_t i) { return "input " + std::to_string(i); });
        f.at(3);
        EXPECT_TRUE(f.equal("a", 1, 1));
        f.at(7);
        EXPECT_FALSE(f.equal("b", 1, 2));
        f.at(8);
        EXPECT_FALSE(f.equal("c", 1, 2));
    }
    EXPECT_FALSE(f.holds("later", false)) << "out of scope nothing describes the input";
    ASSERT_TRUE(f.disagreement());
    EXPECT_EQ(f.disagreement()->quantity, "b");
    EXPECT_EQ(f.disagreement()->where, "input 7");
    EXPECT_EQ(f.disagreement()->what, "1 instead of 2");
    EXPECT_EQ(f.compared(), 4U);
}

TEST(Findings, TooFewAndTooManyAreDisagreements) {
    Findings few, many, right;
    EXPECT_TRUE(right.atLeast("rays", 10, 10) && right.atMost("edges", 10, 10));
    EXPECT_FALSE(right.disagreement());
    EXPECT_FALSE(few.atLeast("rays", 9, 10));
    EXPECT_TRUE(few.disagreement());
    EXPECT_FALSE(many.atMost("edges", 11, 10));
    EXPECT_TRUE(many.disagreement());
}

TEST(Findings, ExcusesAreCountedButDoNotDisagree) {
    Findings f;
    f.excuse("hit");
    EXPECT_TRUE(f.holds("hit", true));
    EXPECT_EQ(f.excused(), 1U);
    EXPECT_EQ(f.compared(), 2U);
    EXPECT_FALSE(f.disagreement());
}

}  // namespace
}  // namespace vkpt
