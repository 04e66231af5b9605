// The measures of BSDFs on functions and models whose figures are known.
#include "analysis/bsdf_measures.h"

#include <gtest/gtest.h>

#include "analysis/bsdf_study.h"
#include "analysis/facet_study.h"
#include "analysis/sphere_quadrature.h"
#include "reference/lone_bsdf.h"

namespace vkpt {
namespace {

constexpr double kPi = reference::kPiOf<double>;

TEST(SphereQuadrature, SquareAndDirectionInvertEachOther) {
    for (double x = 0.01; x < 1; x += 0.07)
        for (double y = 0.02; y < 1; y += 0.07)
            for (const bool upper : {true, false}) {
                const glm::dvec3 w = directionOfSquare({x, y}, upper);
                EXPECT_NEAR(glm::length(w), 1, 1e-12);
                EXPECT_EQ(w.z > 0, upper);
                EXPECT_NEAR(glm::distance(squareOfDirection(w), {x, y}), 0, 1e-9) << x << " " << y;
            }
}

TEST(SphereQuadrature, IntegratesPowersAndNarrowPeaks) {
    const auto of = [](const std::function<double(const glm::dvec3&)>& f, std::span<const glm::dvec3> peaks = {},
                       int depth = 3) {
        const DirectionFunction g = [&](const glm::dvec3& w) { return glm::dvec4(f(w), 0, 0, 0); };
        return integrate(g, {}, peaks, {.peakDepth = depth}).x;
    };
    EXPECT_NEAR(of([](const glm::dvec3&) { return 1.0; }), 2 * kPi, 1e-6);
    EXPECT_NEAR(of([](const glm::dvec3& w) { return w.z; }), kPi, 1e-3);
    EXPECT_NEAR(of([](const glm::dvec3& w) { return w.x * w.x; }), 2 * kPi / 3, 1e-3);
    const glm::dvec3 peak = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));
    const double n = 1e5;  // (w . peak)^n, 0.3 degrees wide, far from the horizon
    EXPECT_NEAR(
        of([&](const glm::dvec3& w) { return (n + 1) / (2 * kPi) * std::pow(std::max(0.0, glm::dot(w, peak)), n); },
           std::span(&peak, 1), 9),
        1, 1e-3);
}

TEST(BsdfMeasures, OfLambertAndMirrorAreKnown) {
    const reference::LoneBsdf lambert(parseBsdfSpec("lambert:color=0.5"), false);
    const BsdfDouble b = lambert.seenFrom<double>(true);
    const BsdfIntegrals integrals = integrateBsdf(b, {0.6, 0, 0.8});
    EXPECT_NEAR(integrals.reflected.x, 0.5, 1e-4);
    EXPECT_NEAR(integrals.pdf, 1, 1e-4);
    const BsdfDraws draws = drawBsdf(b, {0.6, 0, 0.8}, 2000, 1);
    EXPECT_NEAR(draws.mean.x, 0.5, 1e-12);
    EXPECT_NEAR(draws.relativeVariance, 0, 1e-12);
    EXPECT_GT(testBsdfDraws(b, {0.6, 0, 0.8}, 20000, 1).p, 1e-3);

    const reference::LoneBsdf glass(parseBsdfSpec("dielectric"), false);
    const BsdfIntegrals split = integrateBsdf(glass.seenFrom<double>(true), {0, 0, 1});
    EXPECT_NEAR(split.reflected.x, 0.04, 5e-4);
    EXPECT_NEAR(split.transmitted.x, 0.96, 5e-4);
    EXPECT_EQ(split.pdf, 0);
}

// phong's lobe leaves the reciprocal pair alone; a BSDF that is seen from one side as another is not reciprocal.
TEST(BsdfMeasures, ReciprocityErrorSeesAFault) {
    const reference::LoneBsdf glass(parseBsdfSpec("dielectric:alpha=0.3"), false);
    const BsdfDouble front = glass.seenFrom<double>(true);
    BsdfDouble back = glass.seenFrom<double>(false);
    EXPECT_LT(reciprocityError(front, back, 1000, 1), 1e-6);
    back.eta *= 1.01;
    EXPECT_GT(reciprocityError(front, back, 1000, 1), 1e-3);
}

TEST(BsdfStudy, ComparesTwo) {
    const Study study = studyBsdf({.specs = {parseBsdfSpec("lambert"), parseBsdfSpec("mirror")},
                                   .names = {"lambert", "mirror"},
                                   .draws = 1000,
                                   .facets = true});
    EXPECT_EQ(study.json.at("bsdfs").size(), 2U);
    EXPECT_TRUE(study.json.at("bsdfs").at(0).at("facets").is_null());
    EXPECT_NEAR(study.json.at("comparison").at(0).at("energyDifference").get<double>(), -0.2, 1e-3);
    EXPECT_NE(study.table.find("difference of energy"), std::string::npos);
}

Json facetsOf(const std::string& spec) { return facetsJson(reference::LoneBsdf(parseBsdfSpec(spec), false)); }

TEST(FacetStudy, ShowsTheDistributionThatTheyAreDrawnFrom) {
    for (const char* distribution : {"ggx", "beckmann", "phong"}) {
        const Json facets = facetsOf(std::string("torrance_sparrow:alpha=0.4,distribution=") + distribution);
        double projected = 0;  // the integral of D cos over the half sphere, a degree at a time
        for (std::size_t i = 0; i < facets.at("degrees").size(); ++i) {
            const double theta = facets.at("degrees")[i].get<double>() * kPi / 180;
            projected += facets.at("D")[i].get<double>() * std::cos(theta) * std::abs(std::sin(theta)) * kPi;
        }
        EXPECT_NEAR(projected * kPi / 180, 1, 1e-3) << distribution;
    }
}

TEST(FacetStudy, VGroovesHideHalfOfWhatFacesBothDirectionsAtSixtyDegrees) {
    const Json facets = facetsOf("torrance_sparrow:alpha=0.3");
    for (const auto& g : facets.at("G2")) EXPECT_EQ(g.get<double>(), 1);
    // Both directions at 60 degrees on one side: wm lies there too, 2 cos^2 of 60 degrees is 1/2.
    EXPECT_NEAR(facets.at("G2From60")[89 - 60].get<double>(), 0.5, 1e-12);
    EXPECT_TRUE(facetsOf("lambert").is_null());
    EXPECT_TRUE(facetsOf("conductor:alpha=0").is_null());
}

}  // namespace
}  // namespace vkpt
