// Trigonometric polynomials and frames against the standard library.
#include "reference/angle.h"

#include <gtest/gtest.h>

#include "reference/frame.h"
#include "reference/hash.h"

namespace vkpt::reference {
namespace {

TEST(CosSinTurns, IsCloseToTheStandardLibrary) {
    for (int i = -2000; i <= 4000; ++i) {
        const float turns = static_cast<float>(i) / 2000.0F;
        const Vec2<float> value = cosSinTurns(turns);
        EXPECT_NEAR(value.x, std::cos(2 * kPiOf<double> * turns), 2e-7) << turns;
        EXPECT_NEAR(value.y, std::sin(2 * kPiOf<double> * turns), 2e-7) << turns;
    }
}

TEST(CosSinTurns, IsExactAtQuarters) {
    EXPECT_EQ(cosSinTurns(0.0F), Vec2<float>(1, 0));
    EXPECT_EQ(cosSinTurns(0.25F), Vec2<float>(0, 1));
    EXPECT_EQ(cosSinTurns(0.5F), Vec2<float>(-1, 0));
    EXPECT_EQ(cosSinTurns(0.75F), Vec2<float>(0, -1));
}

TEST(ArcTangent2, IsCloseToTheStandardLibraryAllAround) {
    for (int i = 0; i < 5000; ++i) {
        const double angle = 2 * kPiOf<double> * (i + 0.5) / 5000;
        const auto x = static_cast<float>(3 * std::cos(angle)), y = static_cast<float>(3 * std::sin(angle));
        EXPECT_NEAR(arcTangent2(y, x), std::atan2(y, x), 4e-7) << angle;
    }
    EXPECT_EQ(arcTangent2(0.0F, 0.0F), 0.0F);
    EXPECT_FLOAT_EQ(arcTangent2(1.0F, 0.0F), kPiOf<float> / 2);
    EXPECT_FLOAT_EQ(arcTangent2(0.0F, -1.0F), kPiOf<float>);
    EXPECT_FLOAT_EQ(arcTangent2(-2.0F, 0.0F), -kPiOf<float> / 2);
}

TEST(ArcCosine, IsCloseToTheStandardLibrary) {
    for (int i = -1000; i <= 1000; ++i) {
        const float y = static_cast<float>(i) / 1000.0F;
        EXPECT_NEAR(arcCosine(y), std::acos(double{y}), 5e-7) << y;
    }
}

TEST(Frame, IsOrthonormalRightHandedAndInvertible) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const glm::uvec4 h = hash({i, 7, 7, 7});
        const glm::vec3 raw(toUnit(h.x) - 0.5F, toUnit(h.y) - 0.5F, toUnit(h.z) - 0.5F);
        const glm::vec3 n = i == 0 ? glm::vec3(0, 0, -1) : glm::normalize(raw);
        const Frame<float> frame(n);
        EXPECT_NEAR(glm::length(frame.x), 1, 1e-6);
        EXPECT_NEAR(glm::length(frame.y), 1, 1e-6);
        EXPECT_LT(glm::distance(glm::cross(frame.x, frame.y), n), 1e-6);
        const glm::vec3 v(0.3F, -0.4F, 0.5F);
        EXPECT_LT(glm::distance(frame.toWorld(frame.toLocal(v)), v), 1e-6);
        EXPECT_LT(glm::distance(frame.toLocal(n), glm::vec3(0, 0, 1)), 1e-6);
    }
}

}  // namespace
}  // namespace vkpt::reference
