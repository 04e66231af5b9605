// Every map from the unit square: the density of its output is the one it claims.
#include "reference/warp.h"

#include <gtest/gtest.h>

#include "reference/hash.h"
#include "statistics.h"

namespace vkpt::reference {
namespace {

constexpr std::uint32_t kSamples = 200000;

Vec2<float> randomSquare(std::uint32_t i) {
    const glm::uvec4 h = hash({i, 0, 0, 42});
    return {toUnit(h.x), toUnit(h.y)};
}

/// Chi-square deviate of points that should be uniform in [0,1)^2.
template <class Point>
double uniformityOf(Point point) {
    constexpr std::uint32_t kSide = 32;
    std::vector<double> counts(kSide * kSide), expected(kSide * kSide, double{kSamples} / (kSide * kSide));
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        const glm::dvec2 p = glm::clamp(point(randomSquare(i)), 0.0, 0.999999);
        counts[static_cast<std::size_t>(p.y * kSide) * kSide + static_cast<std::size_t>(p.x * kSide)] += 1;
    }
    return test::chiSquareDeviate(counts, expected);
}

double turnsOf(double y, double x) { return std::atan2(y, x) / (2 * kPiOf<double>)+0.5; }

TEST(SquareToDisk, IsUniform) {
    EXPECT_LT(uniformityOf([](const Vec2<float>& u) {
                  const glm::dvec2 d = squareToDisk(u);
                  return glm::dvec2(glm::dot(d, d), turnsOf(d.y, d.x));
              }),
              4);
}

TEST(SquareToDisk, MapsCentreEdgesAndCorners) {
    EXPECT_EQ(squareToDisk(Vec2<float>(0.5F, 0.5F)), Vec2<float>(0, 0));
    EXPECT_NEAR(glm::distance(squareToDisk(Vec2<double>(1, 0.5)), Vec2<double>(1, 0)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(squareToDisk(Vec2<double>(0.5, 1)), Vec2<double>(0, 1)), 0, 1e-12);
    EXPECT_NEAR(glm::distance(squareToDisk(Vec2<double>(0, 0)), Vec2<double>(-std::sqrt(0.5), -std::sqrt(0.5))), 0,
                1e-12);
}

TEST(SquareToCosineHemisphere, HasDensityCosineOverPi) {
    EXPECT_LT(uniformityOf([](const Vec2<float>& u) {  // sin^2 theta is uniform
                  const glm::dvec3 d = squareToCosineHemisphere(u);
                  EXPECT_GE(d.z, 0);
                  EXPECT_NEAR(glm::length(d), 1, 1e-6);
                  return glm::dvec2(d.x * d.x + d.y * d.y, turnsOf(d.y, d.x));
              }),
              4);
}

}  // namespace
}  // namespace vkpt::reference
