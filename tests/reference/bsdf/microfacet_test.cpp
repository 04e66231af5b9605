// Distributions, masking, Fresnel terms and special functions, each held to its definition or to published values.
#include <gtest/gtest.h>

#include "analysis/sphere_quadrature.h"
#include "cases.h"
#include "reference/microfacet/beckmann.h"
#include "reference/microfacet/erf.h"
#include "scene/metals.h"

namespace vkpt::reference {
namespace {

using test::directionAt;
using Surface = Facets<double>;

constexpr std::uint32_t kDistributions[] = {kDistributionGgx, kDistributionBeckmann, kDistributionPhong};
const glm::dvec2 kAlphas[] = {{0.02, 0.02}, {0.3, 0.3}, {1, 1}, {0.1, 0.6}};

double overNormals(const std::function<double(const glm::dvec3&)>& f) {
    const DirectionFunction g = [&](const glm::dvec3& wm) { return glm::dvec4(f(wm), 0, 0, 0); };
    const glm::dvec3 peak[] = {{0, 0, 1}};
    return integrate(g, {}, peak, {.tolerance = 1e-7, .peakDepth = 8}).x;
}

TEST(ErrorFunction, OfFloatsIsThatOfTheLibrary) {
    for (double x = -5; x <= 5; x += 0.01) {
        const auto f = static_cast<float>(x);
        EXPECT_NEAR(errorFunction(f), std::erf(double{f}), 3e-7) << x;
        EXPECT_NEAR(complementaryErrorFunction(f) / std::erfc(double{f}), 1, 1e-5) << x;
    }
    EXPECT_EQ(complementaryErrorFunction(INFINITY), 0);
    EXPECT_EQ(complementaryErrorFunction(-INFINITY), 2);
}

TEST(ErrorFunction, InverseInverts) {
    for (double y = -0.9999; y < 1; y += 0.0101) {
        EXPECT_NEAR(std::erf(inverseErrorFunction(y)), y, 1e-14) << y;
        EXPECT_NEAR(std::erf(double{inverseErrorFunction(static_cast<float>(y))}), y, 1e-6) << y;
    }
    EXPECT_NEAR(std::erfc(inverseErrorFunction(1 - 1e-9)) / 1e-9, 1, 1e-6);
}

TEST(Microfacets, ProjectToTheArea) {
    for (const std::uint32_t distribution : kDistributions) {
        for (const glm::dvec2& alpha : kAlphas) {
            const Surface s{alpha.x, alpha.y, distribution, kMaskingCorrelated};
            EXPECT_NEAR(overNormals([&](const glm::dvec3& wm) { return facetD(s, wm) * wm.z; }), 1, 1e-3)
                << distribution << " " << alpha.x << " " << alpha.y;
        }
    }
}

/// Over cosO the integral of G1 D <wo, wm>: 1 where masking belongs to the distribution.
double seenArea(const Surface& s, const glm::dvec3& wo) {
    return overNormals([&](const glm::dvec3& wm) {
               const double cosine = glm::dot(wo, wm);
               return cosine > 0 ? maskingG1(s, wo, wm) * facetD(s, wm) * cosine : 0.0;
           }) /
           wo.z;
}

// [Heitz 14, eq. 16]
TEST(Masking, ShowsTheProjectedAreaOfTheSurface) {
    for (const std::uint32_t distribution : kDistributions) {
        for (const std::uint32_t masking : {kMaskingCorrelated, kMaskingVGroove}) {
            if (distribution == kDistributionPhong && masking == kMaskingCorrelated) continue;  // see below
            for (const glm::dvec2& alpha : kAlphas)
                for (const double cosine : {0.95, 0.4, 0.1})
                    EXPECT_NEAR(seenArea({alpha.x, alpha.y, distribution, masking}, directionAt(cosine, 0.1)), 1, 3e-3)
                        << distribution << " " << masking << " " << alpha.x << " " << cosine;
        }
    }
}

// Phong's distribution borrows Beckmann's masking [Walter 07, sec. 5.2]: how far off that is.
TEST(Masking, OfPhongDeviatesAsMeasured) {
    double worst = 0;
    for (const double alpha : {0.05, 0.3, 1.0})
        for (const double cosine : {0.95, 0.4, 0.1, 0.02}) {
            const double off = seenArea({alpha, alpha, kDistributionPhong, kMaskingCorrelated}, directionAt(cosine, 0));
            worst = std::max(worst, std::abs(off - 1));
            if (alpha <= 0.3) {
                EXPECT_NEAR(off, 1, 0.05) << alpha << " " << cosine;
            }
        }
    RecordProperty("worst", std::to_string(worst));
    EXPECT_GT(worst, 0.05);  // nobody should take it for exact
    EXPECT_LT(worst, 1.0);
}

TEST(VisibleNormals, OfBeckmannInvertTheDistributionFunction) {
    for (const double cosine : {0.999, 0.7, 0.2, 0.01}) {
        const double sine = std::sqrt(1 - cosine * cosine);
        const auto c = [&](double x) { return cosine * std::erfc(-x) + sine * std::exp(-x * x) / kSqrtPi<double>; };
        const double all = c(cosine / sine);
        for (const double u : {1e-6, 0.01, 0.3, 0.5, 0.9, 0.9999}) {
            EXPECT_NEAR(c(visibleBeckmannSlope(cosine, sine, u)) / all, u, 1e-12) << cosine << " " << u;
            const auto f =
                visibleBeckmannSlope(static_cast<float>(cosine), static_cast<float>(sine), static_cast<float>(u));
            EXPECT_NEAR(c(double{f}) / all, u, 3e-6) << cosine << " " << u;
        }
    }
    EXPECT_NEAR(visibleBeckmannSlope(1.0, 0.0, 0.5), 0, 1e-12);
}

TEST(Fresnel, OfGlassHasThePublishedValues) {
    EXPECT_NEAR(dielectricFresnel(1.0, 1.5), 0.04, 1e-15);
    EXPECT_NEAR(dielectricFresnel(1.0, 2.417), std::pow(1.417 / 3.417, 2), 1e-15);
    // At Brewster's angle, tan = n, only the s part is left: ((n^2 - 1)/(n^2 + 1))^2 / 2.
    EXPECT_NEAR(dielectricFresnel(std::cos(std::atan(1.5)), 1.5), std::pow(1.25 / 3.25, 2) / 2, 1e-14);
    // Total internal reflection beyond asin(1/n), 41.81 degrees; continuous there.
    EXPECT_EQ(dielectricFresnel(std::cos(0.7298), 1 / 1.5), 1);
    EXPECT_LT(dielectricFresnel(std::cos(0.7297), 1 / 1.5), 1);
    EXPECT_GT(dielectricFresnel(std::cos(0.7297), 1 / 1.5), 0.95);
    EXPECT_EQ(dielectricFresnel(0.0, 1.5), 1);
    const double cosT = std::sqrt(1 - (1 - 0.09) / 2.25);  // both ways alike
    EXPECT_NEAR(dielectricFresnel(0.3, 1.5), dielectricFresnel(cosT, 1 / 1.5), 1e-14);
}

TEST(Fresnel, OfMetalsHasThePublishedValues) {
    const auto at0 = [](double n, double k) { return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k); };
    for (const Metal& metal : kMetals) {
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(conductorFresnel<double>(1, metal.eta[c], metal.k[c]), at0(metal.eta[c], metal.k[c]), 1e-12);
            EXPECT_NEAR(conductorFresnel<double>(0, metal.eta[c], metal.k[c]), 1, 1e-12);
        }
        // Linear reflectance at 0 degrees as artists' charts have it [Hoffman 12, table 1].
        const auto r = conductorFresnel(1.0, glm::dvec3(metal.eta), glm::dvec3(metal.k));
        if (metal.symbol == "Cu") {
            EXPECT_LT(glm::distance(r, glm::dvec3(0.955, 0.638, 0.538)), 0.06);
        }
        if (metal.symbol == "Au") {
            EXPECT_LT(glm::distance(r, glm::dvec3(1.0, 0.71, 0.29)), 0.12);
        }
    }
    // Without absorption a metal is a dielectric.
    for (const double c : {0.1, 0.5, 0.9}) EXPECT_NEAR(conductorFresnel(c, 1.5, 0.0), dielectricFresnel(c, 1.5), 1e-14);
}

}  // namespace
}  // namespace vkpt::reference
