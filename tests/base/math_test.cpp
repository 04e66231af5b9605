#include "base/math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vkpt {
namespace {

std::vector<glm::vec3> directions() {
    std::vector<glm::vec3> list;
    for (int i = 0; i < 20000; ++i) {  // a spiral over the sphere
        const double z = 1 - (2 * i + 1) / 20000.0, phi = i * 2.399963229728653, r = std::sqrt(1 - z * z);
        list.emplace_back(r * std::cos(phi), r * std::sin(phi), z);
    }
    return list;
}

TEST(Octahedral, AxesRoundTripExactly) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {-1.0F, 1.0F}) {
            glm::vec3 n(0);
            n[axis] = sign;
            EXPECT_EQ(unpackNormal(packNormal(n)), n);
            for (const float w : {-1.0F, 1.0F}) EXPECT_EQ(unpackTangent(packTangent({n, w})), glm::vec4(n, w));
        }
    }
}

TEST(Octahedral, DirectionsRoundTripWithinTheirGrid) {
    float worstNormal = 0, worstTangent = 0;
    for (const glm::vec3& n : directions()) {
        worstNormal = std::max(worstNormal, glm::distance(unpackNormal(packNormal(n)), n));
        worstTangent = std::max(worstTangent, glm::distance(glm::vec3(unpackTangent(packTangent({n, -1}))), n));
    }
    EXPECT_LT(worstNormal, 7e-5F);  // half a diagonal of the grid, stretched at most by the map
    EXPECT_LT(worstTangent, 1.4e-4F);
    EXPECT_GT(worstTangent, worstNormal);
}

TEST(Octahedral, PackingIsStable) {
    for (const glm::vec3& n : directions()) {
        const std::uint32_t bits = packNormal(n);
        ASSERT_EQ(packNormal(unpackNormal(bits)), bits);
    }
}

TEST(Octahedral, LayoutIsThatOfConstants) {
    EXPECT_EQ(packNormal({1, 0, 0}), 0x00007fffU);
    EXPECT_EQ(packNormal({0, -1, 0}), 0x80010000U);
    EXPECT_EQ(packTangent({0, 1, 0, 1}), 0x3fffU << 15U);
    EXPECT_EQ(packTangent({-1, 0, 0, -1}), 0x80004001U);
}

TEST(Color, LuminanceOfWhiteIsOneAndSrgbMeetsItsEnds) {
    EXPECT_FLOAT_EQ(luminance(glm::vec3(1)), 1);
    EXPECT_EQ(srgbToLinear(0), 0);
    EXPECT_FLOAT_EQ(srgbToLinear(1), 1);
    EXPECT_NEAR(srgbToLinear(0.5F), 0.21404114, 1e-7);
    EXPECT_NEAR(srgbToLinear(0.0404500F), srgbToLinear(0.0404501F), 1e-7);
}

}  // namespace
}  // namespace vkpt
