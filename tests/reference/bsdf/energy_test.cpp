// White furnace: with interreflection, facets that lose nothing reflect all light. And the oracle of multiple
// scattering: a random walk on the microsurface.
#include <gtest/gtest.h>

#include "cases.h"
#include "microsurface.h"

namespace vkpt {
namespace {

using test::directionAt;

/// Largest |albedo - 1| over roughnesses and angles, down to cosines of 1e-5.
void checkFurnace(const std::string& spec, const std::vector<double>& alphas, int cosines, std::uint32_t draws,
                  double tolerance = 5e-3) {
    const reference::LoneBsdf& lone = test::loneBsdf(spec, true);
    for (const bool front : {true, false}) {
        BsdfDouble b = lone.seenFrom<double>(front);
        if (!front && !lone.transmits()) continue;
        b.flags &= ~kBsdfMetal;
        if (b.model == BsdfId::Conductor) {  // facets of reflectance 1
            b.flags |= kBsdfMetal;
            b.eta = glm::dvec3(1e-6);
            b.k = glm::dvec3(1e4);
        }
        for (std::size_t a = 0; a < std::max<std::size_t>(1, alphas.size()); ++a) {
            if (!alphas.empty()) b.alphaX = b.alphaY = alphas[a];
            for (int i = 0; i < cosines; ++i) {
                const double cosine = std::max(1e-5, std::pow((i + 0.5) / cosines, 3));
                const glm::dvec3 mean = test::drawSpread(b, directionAt(cosine, 0.07), draws).mean;
                EXPECT_NEAR(mean.x, 1, tolerance)
                    << spec << (front ? "" : " from inside") << " alpha " << b.alphaX << " cosine " << cosine;
            }
        }
    }
}

const std::vector<double> kRoughnesses{1e-4, 1e-3, 0.01, 0.1, 0.4, 1};

TEST(WhiteFurnace, RoughConductorReflectsAll) { checkFurnace("conductor", kRoughnesses, 8, 60000); }
TEST(WhiteFurnace, RoughDielectricKeepsAll) {
    checkFurnace("dielectric:alpha=0.2", {1e-4, 1e-3, 0.01, 0.1}, 6, 60000);
    checkFurnace("dielectric:alpha=0.2", {0.4, 1}, 6, 200000);
}

/// Over roughnesses and angles, isotropic and not, metal and two glasses.
void checkManyFurnaces(const std::string& facets) {
    const std::vector<double> many{1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02,
                                   0.05, 0.1,  0.2,  0.3,  0.5,  0.7,  0.85, 1};
    constexpr int kCosines = 20;
    constexpr std::uint32_t kDraws = 200000;
    checkFurnace("conductor:" + facets, many, kCosines, kDraws);
    checkFurnace("dielectric:alpha=0.2," + facets, many, kCosines, kDraws);
    checkFurnace("dielectric:alpha=0.2,ior=diamond," + facets, many, kCosines, kDraws);
    for (const char* alpha : {"0.05/0.5", "0.4/0.8"}) {
        checkFurnace(fmt::format("conductor:alpha={},{}", alpha, facets), {}, kCosines, kDraws);
        checkFurnace(fmt::format("dielectric:alpha={},{}", alpha, facets), {}, kCosines, kDraws);
    }
}

TEST(WhiteFurnace, GgxKeepsAllFull) { checkManyFurnaces("distribution=ggx,masking=smith"); }
TEST(WhiteFurnace, SeparableGgxKeepsAllFull) { checkManyFurnaces("distribution=ggx,masking=smith_separable"); }
TEST(WhiteFurnace, BeckmannKeepsAllFull) { checkManyFurnaces("distribution=beckmann,masking=smith"); }
TEST(WhiteFurnace, SeparableBeckmannKeepsAllFull) {
    checkManyFurnaces("distribution=beckmann,masking=smith_separable");
}

/// Of facets that lose nothing, the share of light that leaves after one of them is E, what single scattering keeps.
void checkSingle(double alpha, double cosine, std::uint32_t walks) {
    const glm::dvec3 wo = directionAt(cosine, 0);
    std::uint32_t once = 0;
    for (std::uint32_t i = 0; i < walks; ++i) {
        int facets = 0;
        (void)test::Microsurface(alpha, i).reflectMetal(wo, [&](double) {
            ++facets;
            return glm::dvec3(1);
        });
        if (facets == 1) ++once;
    }
    const reference::LoneBsdf lone(parseBsdfSpec("gltf:metallic=1"), true);
    BsdfDouble b = lone.seenFrom<double>(true);
    b.alphaX = b.alphaY = alpha;
    const double kept = 1 - b.table.albedo(reference::albedoPlace(b, wo)).lost;
    EXPECT_NEAR(static_cast<double>(once) / walks, kept, 0.01) << alpha << " " << cosine;
}

/// Albedo of metal against the walk, whose facets reflect by the same Fresnel term.
void checkMetal(const std::string& spec, double alpha, double cosine, std::uint32_t walks) {
    const reference::LoneBsdf& lone = test::loneBsdf(spec, true);
    BsdfDouble b = lone.seenFrom<double>(true);
    b.alphaX = b.alphaY = alpha;
    const glm::dvec3 wo = directionAt(cosine, 0);
    glm::dvec3 walked(0);
    for (std::uint32_t i = 0; i < walks; ++i) {
        test::Microsurface surface(alpha, i);
        walked += surface.reflectMetal(wo, [&](double c) { return reference::facetFresnel(b, c); }) /
                  static_cast<double>(walks);
    }
    const glm::dvec3 mean = test::drawSpread(b, wo, 20000).mean;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], walked[c], 0.02) << spec << " " << alpha << " " << cosine;
}

TEST(Interreflection, OfMetalIsThatOfAWalkOnTheMicrosurface) {
    for (const double cosine : {0.9, 0.3}) {
        checkSingle(0.3, cosine, 40000);
        checkSingle(1, cosine, 40000);
        for (const double alpha : {0.1, 0.6, 1.0}) checkMetal("conductor:metal=Au", alpha, cosine, 20000);
    }
}

const std::vector<double> kWalkAlphas{0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1};

TEST(Interreflection, OfMetalIsThatOfAWalkOnTheMicrosurfaceFull) {
    for (const double alpha : kWalkAlphas) {
        for (const double cosine : {1.0, 0.7, 0.4, 0.2, 0.1, 0.05}) {
            checkSingle(alpha, cosine, 400000);
            for (const char* metal : {"Cu", "Fe", "Au", "Ag", "Al", "Hg"})
                checkMetal(fmt::format("conductor:metal={}", metal), alpha, cosine, 100000);
        }
    }
}

/// Reflected and transmitted share of glass, from both sides, against the walk, in which nothing is absorbed.
void checkGlass(double ior, double alpha, double cosine, std::uint32_t walks) {
    const reference::LoneBsdf& lone =
        test::loneBsdf(ior == 1.5 ? "dielectric:alpha=0.2" : fmt::format("dielectric:alpha=0.2,ior={}", ior), true);
    for (const bool front : {true, false}) {
        BsdfDouble b = lone.seenFrom<double>(front);
        b.alphaX = b.alphaY = alpha;
        const glm::dvec3 wo = directionAt(cosine, 0);
        double walked = 0;
        for (std::uint32_t i = 0; i < walks; ++i)
            walked += test::Microsurface(alpha, i).reflectGlass(wo, b.eta.x) ? 1.0 / walks : 0.0;
        double reflected = 0, transmitted = 0;
        constexpr std::uint32_t kDraws = 40000;
        for (std::uint32_t i = 0; i < kDraws; ++i) {
            const test::Spread r = test::spread(i);
            const auto s = reference::sampleBsdf(b, wo, r.uLobe, r.u);
            (s.wi.z > 0 ? reflected : transmitted) += s.weight.x * (s.wi.z > 0 ? 1 : b.eta.x * b.eta.x) / kDraws;
        }
        SCOPED_TRACE(fmt::format("ior {} alpha {} cosine {}{}", ior, alpha, cosine, front ? "" : " inside"));
        EXPECT_NEAR(reflected, walked, 0.02);
        EXPECT_NEAR(transmitted, 1 - walked, 0.02);
    }
}

TEST(Interreflection, OfGlassIsThatOfAWalkOnTheMicrosurface) {
    for (const double alpha : {0.3, 1.0}) checkGlass(1.5, alpha, 0.6, 20000);
}

TEST(Interreflection, OfGlassIsThatOfAWalkOnTheMicrosurfaceFull) {
    for (const double ior : {1.33, 1.5, 1.8, 2.4})
        for (const double alpha : kWalkAlphas)
            for (const double cosine : {1.0, 0.8, 0.6, 0.4, 0.2, 0.1, 0.05}) checkGlass(ior, alpha, cosine, 100000);
}

}  // namespace
}  // namespace vkpt
