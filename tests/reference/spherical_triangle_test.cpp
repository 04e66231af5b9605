// Triangles as a point sees them: solid angles against closed forms, points against their density.
#include "reference/lights/spherical_triangle.h"

#include <gtest/gtest.h>

#include <array>

#include "reference/hash.h"
#include "statistics.h"

namespace vkpt::reference {
namespace {

using Corners = std::array<glm::dvec3, 3>;

/// By the lengths of the sides alone. [L'Huilier 1812]
double lHuilier(const Corners& corners) {
    const auto side = [&](std::size_t i) {
        const glm::dvec3 u = glm::normalize(corners[i]), v = glm::normalize(corners[(i + 1) % 3]);
        return 2 * std::asin(std::min(1.0, glm::length(u - v) / 2));
    };
    const double a = side(1), b = side(2), c = side(0), s = (a + b + c) / 2;
    return 4 * std::atan(std::sqrt(std::max(
                   0.0, std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2))));
}

template <class Real>
SphericalTriangle<Real> make(const Corners& c) {
    return {Vec3<Real>(c[0]), Vec3<Real>(c[1]), Vec3<Real>(c[2])};
}

/// From a far and small one to one that fills the view, and slivers along either side.
const std::array kTriangles{
    Corners{glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}},
    Corners{glm::dvec3(-1, -1, -2), {2, -1, -2}, {0, 1.5, -2}},
    Corners{glm::dvec3(-40, -30, -0.0625), {35, -30, -0.0625}, {0, 45, -0.0625}},
    Corners{glm::dvec3(0.25, 0.125, -3), {0.2578125, 0.125, -3}, {0.25, 0.140625, -3.0078125}},
    Corners{glm::dvec3(5, 7, -900), {5.0078125, 7, -900}, {5, 7.015625, -900.0078125}},
    Corners{glm::dvec3(-8, 0, -1), {8, 0, -1}, {8, 0.001, -1}},
    Corners{glm::dvec3(-8, 0, -1), {8, 0, -1}, {-8, 0.001, -1}},
    Corners{glm::dvec3(0.02, 0.5, -0.6), {3, 0.4, -2}, {1, -6, 0.5}},
};

glm::dvec2 pairOfNumbers(std::uint32_t i) {
    const glm::uvec4 h = hash({i, 7, 0, 45});
    return {toUnit(h.x), toUnit(h.y)};
}

TEST(SphericalTriangle, SolidAngleIsThatOfTheSides) {
    EXPECT_NEAR(make<double>(kTriangles[0]).solidAngle(), kPiOf<double> / 2, 1e-14) << "an octant";
    for (const Corners& corners : kTriangles) {
        const double truth = make<double>(corners).solidAngle();
        EXPECT_NEAR(truth, lHuilier(corners), 1e-5 * truth + 1e-13);
        EXPECT_NEAR(make<float>(corners).solidAngle(), truth, 2e-6 * truth);
    }
    const Corners& far = kTriangles[4];  // area, cosine and distance
    const glm::dvec3 middle = (far[0] + far[1] + far[2]) / 3.0, n = glm::cross(far[1] - far[0], far[2] - far[0]) / 2.0;
    const double d = glm::length(middle);
    EXPECT_NEAR(make<double>(far).solidAngle() / (std::abs(glm::dot(n, middle)) / (d * d * d)), 1, 1e-6);
}

TEST(SphericalTriangle, KnowsItsSidesAndItsPlane) {
    EXPECT_FLOAT_EQ(make<float>({glm::dvec3(-1, -1, -2), {1, -1, -2}, {0, 1, -2}}).height(), 2);
    EXPECT_FLOAT_EQ(make<float>({glm::dvec3(-1, -1, -2), {0, 1, -2}, {1, -1, -2}}).height(), -2);
    EXPECT_EQ(make<float>({glm::dvec3(-1, -1, 0), {1, -1, 0}, {0, 1, 0}}).height(), 0) << "in its plane";
    EXPECT_EQ(make<float>({glm::dvec3(1, 1, -1), {2, 2, -2}, {3, 3, -3}}).solidAngle(), 0) << "of no area";
}

// Each of 64 parts gets points in proportion to the solid angle that it covers.
TEST(SphericalTriangle, PointsAreUniformInSolidAngle) {
    constexpr std::uint32_t kPoints = 100000, kSide = 8;
    for (const Corners& corners : kTriangles) {
        const auto triangle = make<float>(corners);
        const auto at = [&](double b0, double b1) {
            return b0 / kSide * corners[0] + b1 / kSide * corners[1] + (1 - (b0 + b1) / kSide) * corners[2];
        };
        std::vector<double> counts(2 * kSide * kSide), expected(2 * kSide * kSide);
        for (std::uint32_t i = 0; i < kPoints; ++i) {
            const glm::dvec3 b = triangle.point(glm::vec2(pairOfNumbers(i)));
            EXPECT_NEAR(b.x + b.y + b.z, 1, 1e-6);
            EXPECT_GE(std::min({b.x, b.y, b.z}), 0);
            const double x = std::min(b.x, 0.999999) * kSide, y = std::min(b.y, 0.999999) * kSide;
            const bool upper = x - std::floor(x) + y - std::floor(y) > 1;
            counts[2 * (static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)) + (upper ? 1 : 0)] += 1;
        }
        double sum = 0;
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x + y < kSide; ++x) {
                const std::size_t cell = 2 * (y * kSide + x);
                const double i = x, j = y;
                expected[cell] = make<double>({at(i, j), at(i + 1, j), at(i, j + 1)}).solidAngle();
                if (x + y + 1 < kSide)
                    expected[cell + 1] = make<double>({at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)}).solidAngle();
                sum += expected[cell] + expected[cell + 1];
            }
        EXPECT_NEAR(sum, triangle.solidAngle(), 1e-5 * sum);
        for (double& e : expected) e *= kPoints / sum;
        EXPECT_LT(test::chiSquareDeviate(counts, expected), 4) << "first corner " << corners[0].x;
    }
}

// Seen from just off their plane arcs vanish or become half circles, to floats: points and solid angles stay finite.
TEST(SphericalTriangle, GrazingOnesStayFinite) {
    for (std::uint32_t i = 0; i < 200000; ++i) {
        const auto number = [&](std::uint32_t k) { return toUnit(hash({i, k, 0, 46}).x) - 0.5F; };
        const glm::vec3 a(number(0), number(1), 0), b(number(2), number(3), 0), c(number(4), number(5), 0);
        const glm::vec3 from(number(6) * 2, number(7) * 2, std::ldexp(1.0F, -static_cast<int>(i % 24)));
        const SphericalTriangle<float> seen(a - from, b - from, c - from);
        const glm::vec3 point = seen.point(glm::vec2(pairOfNumbers(i)));
        ASSERT_TRUE(seen.solidAngle() >= 0 && seen.solidAngle() <= 6.2832F) << i;
        if (seen.solidAngle() > 0) {
            ASSERT_NEAR(point.x + point.y + point.z, 1, 1e-5) << i;
        }
    }
}

// What is rendered follows its truth, however thin, small or wide the triangle is seen. Barycentrics are rounded, so a
// point is off by some 1e-7 of the largest corner's distance.
TEST(SphericalTriangle, FloatKeepsToDouble) {
    for (const Corners& corners : kTriangles) {
        const auto rounded = make<float>(corners);
        const auto exact = make<double>(corners);
        const double reach = std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
        const auto at = [&](const glm::dvec3& b) { return b.x * corners[0] + b.y * corners[1] + b.z * corners[2]; };
        for (std::uint32_t i = 0; i < 10000; ++i) {
            const glm::dvec2 u = pairOfNumbers(i);
            const glm::dvec3 a = at(rounded.point(glm::vec2(u))), b = at(exact.point(u));
            EXPECT_LT(glm::distance(glm::normalize(a), glm::normalize(b)), 2e-5 + 3e-7 * reach / glm::length(b))
                << "first corner " << corners[0].x << ", u " << u.x << ' ' << u.y;
        }
    }
}

}  // namespace
}  // namespace vkpt::reference
