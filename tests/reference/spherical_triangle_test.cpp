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
SphericalTriangle<Real> make(const Corners& c, const glm::dvec3& from = glm::dvec3(0)) {
    return {Vec3<Real>(from), Vec3<Real>(c[0]), Vec3<Real>(c[1]), Vec3<Real>(c[2])};
}

/// What floats can hold, so that a float triangle and its truth are of the same corners.
glm::dvec3 rounded(const glm::dvec3& v) { return glm::dvec3(glm::vec3(v)); }
Corners rounded(const Corners& c) { return {rounded(c[0]), rounded(c[1]), rounded(c[2])}; }

/// From a far and small one to one that fills the view, and slivers along either side; of digits that no product keeps.
const std::array kTriangles{
    Corners{glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}},
    rounded(Corners{glm::dvec3(-1.1, -1.1, -2.2), {2.2, -1.1, -2.2}, {0, 1.7, -2.3}}),
    rounded(Corners{glm::dvec3(-40.3, -30.1, -0.0626), {35.7, -30.1, -0.0626}, {0.3, 45.2, -0.0626}}),
    rounded(Corners{glm::dvec3(0.27, 0.13, -3.1), {0.2786, 0.13, -3.1}, {0.27, 0.1464, -3.1081}}),
    rounded(Corners{glm::dvec3(5.1, 7.3, -900.7), {5.113, 7.3, -900.7}, {5.1, 7.317, -900.711}}),
    rounded(Corners{glm::dvec3(-8.3, 0, -1.1), {8.3, 0, -1.1}, {8.3, 0.0011, -1.1}}),
    rounded(Corners{glm::dvec3(-8.3, 0, -1.1), {8.3, 0, -1.1}, {-8.3, 0.0011, -1.1}}),
    rounded(Corners{glm::dvec3(0.02, 0.5, -0.6), {3, 0.4, -2}, {1, -6, 0.5}}),
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
        const SphericalTriangle<float> seen(from, a, b, c);
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
        const auto inFloat = make<float>(corners);
        const auto exact = make<double>(corners);
        const double reach = std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
        const auto at = [&](const glm::dvec3& b) { return b.x * corners[0] + b.y * corners[1] + b.z * corners[2]; };
        for (std::uint32_t i = 0; i < 10000; ++i) {
            const glm::dvec2 u = pairOfNumbers(i);
            const glm::dvec3 a = at(inFloat.point(glm::vec2(u))), b = at(exact.point(u));
            EXPECT_LT(glm::distance(glm::normalize(a), glm::normalize(b)), 2e-5 + 3e-7 * reach / glm::length(b))
                << "first corner " << corners[0].x << ", u " << u.x << ' ' << u.y;
        }
    }
}

// A small light keeps its solid angle at any distance from the origin and from the point.
TEST(SphericalTriangle, SmallOnesFarAwayKeepTheirDigits) {
    int compared = 0;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const auto number = [&](std::uint32_t k) { return toUnit(hash({i, k, 0, 47}).x) - 0.5; };
        const double size = std::ldexp(1.0, -static_cast<int>(i % 16)), far = 10 + 3 * number(0);
        const glm::dvec3 from = rounded({number(1), number(2), number(3)});
        const auto corner = [&](std::uint32_t k) {
            return glm::dvec3(far + size * number(k), 5 + size * number(k + 1), size * number(k + 2));
        };
        const Corners corners = rounded(Corners{corner(4), corner(7), corner(10)});
        const double truth = make<double>(corners, from).solidAngle();
        const glm::dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double elevation = std::abs(glm::dot(glm::normalize(n), glm::normalize(corners[0] - from)));
        if (!(elevation > 0.01)) continue;  // of no area, to floats, or seen edge-on
        ++compared;
        EXPECT_NEAR(make<float>(corners, from).solidAngle() / truth, 1, 8e-7 / elevation + 1e-6)
            << i << ", size " << size;
    }
    EXPECT_GT(compared, 4500);
}

// Beside an edge two corners are nearly opposite. What a surface that faces the light there gets of it is right.
TEST(SphericalTriangle, ItsLightIsRightBesideItsEdges) {
    const Corners corners = rounded(Corners{glm::dvec3(-1.03, -0.37, 0.11), {0.93, -0.41, 0.07}, {-0.17, 1.23, 0.19}});
    const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    for (std::size_t edge = 0; edge < 3; ++edge)
        for (double nearness = 50; nearness < 4e4; nearness *= 5) {
            const glm::dvec3 along = corners[(edge + 1) % 3] - corners[edge], foot = corners[edge] + 0.47 * along,
                             from = rounded(foot + glm::length(along) / nearness * normal),
                             facing = glm::normalize(glm::cross(normal, along));
            const auto inFloat = make<float>(corners, from);
            const auto exact = make<double>(corners, from);
            double sumFloat = 0, sumExact = 0;
            for (std::uint32_t i = 0; i < 20000; ++i) {
                const auto cosine = [&](const glm::dvec3& b) {
                    const glm::dvec3 point = b.x * corners[0] + b.y * corners[1] + b.z * corners[2];
                    return std::max(0.0, glm::dot(facing, glm::normalize(point - from)));
                };
                const glm::dvec2 u = pairOfNumbers(i);
                sumFloat += cosine(inFloat.point(glm::vec2(u)));
                sumExact += cosine(exact.point(u));
            }
            EXPECT_NEAR(inFloat.solidAngle() / exact.solidAngle(), 1, 1e-3) << edge << ' ' << nearness;
            EXPECT_NEAR(sumFloat / sumExact, 1, 2e-3) << edge << ' ' << nearness;
        }
}

}  // namespace
}  // namespace vkpt::reference
