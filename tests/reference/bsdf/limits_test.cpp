// Limits and published claims of single models.
#include <gtest/gtest.h>

#include "analysis/sphere_quadrature.h"
#include "cases.h"

namespace vkpt {
namespace {

using test::directionAt;

BsdfDouble bsdfOf(std::string_view spec, bool multiscatter = false) {
    return test::loneBsdf(std::string(spec), multiscatter).seenFrom<double>(true);
}

template <class Check>
void forPairs(const Check& check) {
    for (const double cosO : {0.05, 0.4, 0.95})
        for (const double cosI : {0.1, 0.5, 0.999})
            for (const double turns : {0.0, 0.2, 0.5}) check(directionAt(cosO, 0.1), directionAt(cosI, 0.1 + turns));
}

TEST(OrenNayar, WithoutRoughnessIsLambert) {
    for (const std::string_view model : {"oren_nayar:sigma=0,color=0.7", "eon:roughness=0,color=0.7"}) {
        const BsdfDouble rough = bsdfOf(model), lambert = bsdfOf("lambert:color=0.7");
        forPairs([&](const glm::dvec3& wo, const glm::dvec3& wi) {
            EXPECT_NEAR(reference::evalBsdf(rough, wo, wi).x, reference::evalBsdf(lambert, wo, wi).x, 1e-14) << model;
        });
    }
}

// [Oren 94]: C1 to C3 and both terms by hand, at azimuths where the terms separate.
TEST(OrenNayar, HasThePublishedTerms) {
    const double s2 = 0.25, pi = reference::kPiOf<double>;
    const BsdfDouble b = bsdfOf("oren_nayar:sigma=0.5,color=0.6");
    const double a = 1.1, e = 0.7;  // angles of wi and wo
    const auto at = [](double theta, double turns) { return directionAt(std::cos(theta), turns); };
    const double c1 = 1 - 0.5 * s2 / (s2 + 0.33), r = s2 / (s2 + 0.09), l2 = 0.17 * 0.6 * s2 / (s2 + 0.13);
    const double c3 = 0.125 * r * std::pow(4 * a * e / (pi * pi), 2);
    const double same = c1 + 0.45 * r * std::sin(a) * std::tan(e) + l2 * (1 - std::pow(2 * e / pi, 2));
    const double across = c1 + c3 * std::tan((a + e) / 2) + l2;
    const double away =
        c1 - 0.45 * r * (std::sin(a) - std::pow(2 * e / pi, 3)) * std::tan(e) + l2 * (1 + std::pow(2 * e / pi, 2));
    EXPECT_NEAR(reference::evalBsdf(b, at(e, 0), at(a, 0)).x, 0.6 / pi * same, 1e-7);
    EXPECT_NEAR(reference::evalBsdf(b, at(e, 0), at(a, 0.25)).x, 0.6 / pi * across, 1e-7);
    EXPECT_NEAR(reference::evalBsdf(b, at(e, 0), at(a, 0.5)).x, 0.6 / pi * away, 1e-7);
}

TEST(Eon, WhiteSurfaceKeepsAllEnergy) {
    for (const std::string_view spec : {"eon:roughness=0.3,color=1", "eon:roughness=1,color=1"})
        for (const double cosine : {1.0, 0.5, 0.1})
            EXPECT_NEAR(integrateBsdf(bsdfOf(spec), directionAt(cosine, 0)).reflected.x, 1, 5e-4) << spec;
}

TEST(Anisotropy, OfEqualAlphasIsIsotropic) {
    for (const char* model : {"conductor", "dielectric", "torrance_sparrow"}) {
        for (const char* distribution : {"ggx", "beckmann", "phong"}) {
            const auto b = bsdfOf(fmt::format("{}:alpha=0.3/0.3,distribution={}", model, distribution));
            const glm::dvec3 wo = directionAt(0.6, 0), wi = directionAt(0.5, 0.3);
            for (const double turns : {0.1, 0.37}) {
                const glm::dvec3 wo2 = directionAt(0.6, turns), wi2 = directionAt(0.5, 0.3 + turns);
                EXPECT_NEAR(reference::evalBsdf(b, wo, wi).x, reference::evalBsdf(b, wo2, wi2).x, 1e-12);
                EXPECT_NEAR(reference::pdfBsdf(b, wo, wi), reference::pdfBsdf(b, wo2, wi2), 1e-12);
            }
        }
    }
}

TEST(Anisotropy, TurnedByAQuarterIsTheSameWithAlphasSwapped) {
    for (const char* distribution : {"ggx", "beckmann", "phong"}) {
        const auto b = bsdfOf(fmt::format("conductor:alpha=0.1/0.4,distribution={}", distribution));
        const auto swapped = bsdfOf(fmt::format("conductor:alpha=0.4/0.1,distribution={}", distribution));
        const double there = reference::evalBsdf(b, directionAt(0.6, 0.03), directionAt(0.5, 0.4)).x;
        EXPECT_NEAR(there, reference::evalBsdf(swapped, directionAt(0.6, 0.28), directionAt(0.5, 0.65)).x, 1e-12);
        EXPECT_GT(std::abs(there / reference::evalBsdf(swapped, directionAt(0.6, 0.03), directionAt(0.5, 0.4)).x - 1),
                  0.05);
    }
}

// Just above the delta limit as much light goes where the smooth model sends it.
TEST(Roughness, TendsToTheSmoothModel) {
    for (const char* model : {"conductor:metal=Au", "dielectric", "torrance_sparrow"}) {
        for (const char* distribution : {"ggx", "beckmann", "phong"}) {
            const std::string spec =
                fmt::format("{}{}alpha=0.2,distribution={}", model,
                            std::string_view(model).find(':') == std::string_view::npos ? ":" : ",", distribution);
            BsdfDouble narrow = bsdfOf(spec), smooth = narrow;
            narrow.alphaX = narrow.alphaY = 2e-4;
            smooth.alphaX = smooth.alphaY = 0;
            for (const double cosine : {0.9, 0.4}) {
                const glm::dvec3 wo = directionAt(cosine, 0.1);
                const auto n = test::drawSpread(narrow, wo, 4096), s = test::drawSpread(smooth, wo, 4096);
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(n.mean[c], s.mean[c], 4e-3) << spec << " " << cosine;
            }
        }
    }
}

// A sphere of lambda = (e + 2)/(2 pi) reflects 4 e/(e + 4) of its light at normal incidence: the lecture's warning.
TEST(BlinnPhong, LectureNormalizationGainsEnergy) {
    const auto albedo = [](std::string_view spec) { return integrateBsdf(bsdfOf(spec), {0, 0, 1}).reflected.x; };
    EXPECT_NEAR(albedo("blinn_phong:color=1,exponent=50,normalization=lecture"), 200.0 / 54, 2e-3);
    EXPECT_NEAR(albedo("blinn_phong:color=1,exponent=1000,normalization=lecture"), 4000.0 / 1004, 2e-2);
    EXPECT_NEAR(albedo("blinn_phong:color=1,exponent=50"), 1, 1e-3);
    EXPECT_NEAR(albedo("blinn_phong:color=1,exponent=1000"), 1, 5e-3);
    EXPECT_NEAR(albedo("blinn_phong:color=1,exponent=0"), 1, 1e-3);
}

TEST(Phong, KeepsEnergyAtNormalIncidenceAndLosesItBelowTheHorizon) {
    const BsdfDouble b = bsdfOf("phong:color=1,exponent=20");
    EXPECT_NEAR(integrateBsdf(b, {0, 0, 1}).reflected.x, 1, 1e-3);
    EXPECT_LT(integrateBsdf(b, directionAt(0.1, 0)).reflected.x, 0.5);
}

// Off is the specification to the letter, whose Fresnel mix gains at grazing angles; on loses and gains nothing.
TEST(Gltf, MultiscatterMendsTheGainOfTheFresnelMix) {
    const glm::dvec3 wo = directionAt(0.1, 0);
    EXPECT_NEAR(integrateBsdf(bsdfOf("gltf:roughness=0.3", false), wo).reflected.x, 1.28, 0.01);
    EXPECT_NEAR(integrateBsdf(bsdfOf("gltf:roughness=0.3", true), wo).reflected.x, 1, 4e-3);
    EXPECT_LT(integrateBsdf(bsdfOf("gltf:metallic=1,roughness=1", false), wo).reflected.x, 0.8);
    EXPECT_NEAR(integrateBsdf(bsdfOf("gltf:metallic=1,roughness=1", true), wo).reflected.x, 1, 4e-3);
}

TEST(AshikhminShirley, WhiteSubstrateGainsNothing) {
    const BsdfDouble b = bsdfOf("ashikhmin_shirley:color=0.2,diffuse=1,exponent=100");
    for (const double cosine : {1.0, 0.7, 0.4, 0.1})
        EXPECT_LT(integrateBsdf(b, directionAt(cosine, 0)).reflected.x, 1) << cosine;
}

TEST(Plastic, TendsToTheSmoothModel) {
    const BsdfDouble rough = bsdfOf("plastic:alpha=0.1");
    BsdfDouble narrow = rough, smooth = rough;
    narrow.alphaX = narrow.alphaY = 2e-4;
    smooth.alphaX = smooth.alphaY = 0;
    for (const double cosine : {0.9, 0.4}) {
        const glm::dvec3 wo = directionAt(cosine, 0.1);
        EXPECT_NEAR(test::drawSpread(narrow, wo, 4096).mean.x, test::drawSpread(smooth, wo, 4096).mean.x, 4e-3);
    }
}

TEST(Plastic, OverAWhiteBaseKeepsAllEnergy) {
    for (const std::string_view spec : {"plastic:diffuse=1,alpha=0", "plastic:diffuse=1,alpha=0.1"})
        for (const double cosine : {0.95, 0.4, 0.1})
            EXPECT_NEAR(integrateBsdf(bsdfOf(spec), directionAt(cosine, 0)).reflected.x, 1, 4e-3) << spec << cosine;
}

TEST(Dielectric, SmoothSplitsByFresnelAndScalesRadiance) {
    const BsdfDouble b = bsdfOf("dielectric:ior=1.5,color=0.5");
    EXPECT_FALSE(reference::hasDensity(b, {0, 0, 1}));
    const auto through = reference::sampleBsdf(b, {0, 0, 1}, 0.5, {0.5, 0.5});
    EXPECT_NEAR(glm::distance(through.wi, {0, 0, -1}), 0, 1e-12);
    EXPECT_NEAR(through.weight.x, 0.5 / 2.25, 1e-12);
    const auto back = reference::sampleBsdf(b, {0, 0, 1}, 0.03, {0.5, 0.5});
    EXPECT_NEAR(glm::distance(back.wi, {0, 0, 1}), 0, 1e-12);
    EXPECT_NEAR(back.weight.x, 1, 1e-12);
    const glm::dvec3 wo = directionAt(std::cos(0.5), 0.2);
    const auto bent = reference::sampleBsdf(b, wo, 0.5, {0.5, 0.5});
    EXPECT_NEAR(std::sin(0.5) / 1.5, std::hypot(bent.wi.x, bent.wi.y), 1e-12);  // Snell
    EXPECT_NEAR(bent.wi.x * wo.y - bent.wi.y * wo.x, 0, 1e-12);
}

TEST(Dielectric, OfEqualMediaIsNotThere) {
    BsdfDouble b = bsdfOf("dielectric:alpha=0.3");
    b.eta = glm::dvec3(1);
    EXPECT_FALSE(reference::hasDensity(b, {0, 0, 1}));
    const glm::dvec3 wo = directionAt(0.3, 0.2);
    const auto s = reference::sampleBsdf(b, wo, 0.0, {0.2, 0.3});
    EXPECT_NEAR(glm::distance(s.wi, -wo), 0, 1e-12);
    EXPECT_NEAR(s.weight.x, 1, 1e-12);
}

}  // namespace
}  // namespace vkpt
