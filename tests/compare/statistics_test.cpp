#include "compare/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace vkpt {
namespace {

TEST(Statistics, MomentsUseTheUnbiasedVariance) {
    const std::array values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
    const Moments m = momentsOf(values);
    EXPECT_EQ(m.count, 8U);
    EXPECT_DOUBLE_EQ(m.mean, 5);
    EXPECT_DOUBLE_EQ(m.variance, 32.0 / 7);
}

TEST(Statistics, ZTestGivesTheNormalTails) {
    EXPECT_NEAR(zTest(1.959963984540054, 0, 1).p, 0.05, 1e-12);
    EXPECT_NEAR(zTest(5, 2, 1).statistic, 3, 1e-12);
    EXPECT_NEAR(zTest(5, 2, 1).p, 0.0026997960632601866, 1e-12);
    EXPECT_EQ(zTest(1, 1, 0).p, 1);
    EXPECT_EQ(zTest(1, 2, 0).p, 0);
}

// Expected: Welch's formulas, and Simpson's rule over the density of Student's t, both evaluated apart from this code.
TEST(Statistics, WelchTestAgreesWithNumericIntegration) {
    const std::array a{27.5, 21.0, 19.0, 23.6, 17.0, 17.9, 16.9, 20.1, 21.9, 22.6, 23.1, 19.6, 19.0, 21.7, 21.4};
    const std::array b{27.1, 22.0, 20.8, 23.4, 23.4, 23.5, 25.8, 22.0, 24.8, 20.2, 21.9, 22.1, 22.9, 30.5, 31.3};
    const TestResult r = welchTest(momentsOf(a), momentsOf(b));
    EXPECT_NEAR(r.statistic, -2.949236837313106, 1e-10);
    EXPECT_NEAR(r.degrees, 27.31161047222031, 1e-10);
    EXPECT_NEAR(r.p, 0.006460408027456, 1e-10);
}

TEST(Statistics, WelchTestOfConstantsIsDecidedByTheMeans) {
    EXPECT_EQ(welchTest({4, 1, 0}, {4, 1, 0}).p, 1);
    EXPECT_EQ(welchTest({4, 1, 0}, {4, 2, 0}).p, 0);
}

// Under the null hypothesis p is uniform: 1,000 pairs of unequal variance reject 5 % at level 0.05.
TEST(Statistics, WelchTestRejectsAtItsLevel) {
    std::mt19937 generator(1);
    std::normal_distribution<double> narrow(0, 1), broad(0, 3);
    int rejected = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        std::vector<double> a(20), b(12);
        for (double& v : a) v = narrow(generator);
        for (double& v : b) v = broad(generator);
        if (welchTest(momentsOf(a), momentsOf(b)).p < 0.05) ++rejected;
    }
    EXPECT_NEAR(rejected, 50, 4 * std::sqrt(1000 * 0.05 * 0.95));
}

TEST(Statistics, ChiSquareTestOfAFairAndALoadedDie) {
    const std::vector<double> expected(6, 10);
    const std::vector<double> fair{5, 8, 9, 8, 10, 20};
    const TestResult r = chiSquareTest(fair, expected);
    EXPECT_DOUBLE_EQ(r.statistic, 13.4);
    EXPECT_DOUBLE_EQ(r.degrees, 5);
    EXPECT_NEAR(r.p, 0.0199, 5e-5);
    EXPECT_EQ(chiSquareTest(expected, expected).p, 1);
}

TEST(Statistics, ChiSquareTestPoolsThinCells) {
    const std::vector<double> expected{1, 1, 1, 1, 1, 50, 45}, observed{0, 0, 0, 0, 5, 50, 45};
    const TestResult r = chiSquareTest(observed, expected);
    EXPECT_DOUBLE_EQ(r.degrees, 2);
    EXPECT_DOUBLE_EQ(r.statistic, 0);
}

TEST(Statistics, ChiSquareTestRefusesTheImpossible) {
    const std::vector<double> expected{0, 50, 50}, observed{1, 50, 49};
    EXPECT_EQ(chiSquareTest(observed, expected).p, 0);
}

TEST(Statistics, SidakLevelRestoresTheFamilyLevel) {
    EXPECT_DOUBLE_EQ(sidakLevel(0.01, 1), 0.01);
    for (const std::size_t tests : {2U, 100U, 1000000U}) {
        const double level = sidakLevel(0.01, tests);
        EXPECT_NEAR(1 - std::pow(1 - level, static_cast<double>(tests)), 0.01, 1e-9);
    }
}

}  // namespace
}  // namespace vkpt
