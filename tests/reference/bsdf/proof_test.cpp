// What every BSDF owes, over the registry and grids of parameters: densities, draws, weights, reciprocity, energy.
#include <gtest/gtest.h>

#include <set>

#include "cases.h"

namespace vkpt {
namespace {

using test::directionAt;
using test::forEachBsdf;

/// Oren-Nayar's albedo is bounded, its weight is not; phong facets and lobes are not drawn as they are seen.
bool drawsWithoutVisibility(const BsdfDouble& b) {
    return (b.flags & kBsdfDistributionMask) == kDistributionPhong &&
           (b.flags >> kBsdfMaskingShift & kBsdfMaskingMask) != kMaskingVGroove;
}

/// How much the published formula itself may reflect of what arrives: the lecture's normalization of Blinn-Phong up to
/// 4 times, Phong's facets under Beckmann's masking up to 1.49 where light grazes rough surfaces (alpha 1, cosine
/// 0.03).
double mostEnergy(const BsdfDouble& b) {
    if (b.model == BsdfId::BlinnPhong && (b.flags & kBsdfConserving) == 0) return 4;
    if (b.model == BsdfId::Gltf && !b.multiscatter) return 2;  // the specification's Fresnel mix
    const bool facets = b.model == BsdfId::Conductor || b.model == BsdfId::Dielectric || b.model == BsdfId::Plastic;
    return facets && drawsWithoutVisibility(b) ? 1.6 : 1 + 5e-3;
}

TEST(EveryBsdf, IsAmongTheCases) {
    std::set<BsdfId> seen;
    for (const test::BsdfCase& c : test::quickCases()) seen.insert(parseBsdfSpec(c.spec).model);
    EXPECT_EQ(seen.size(), kBsdfModels.size());
}

void checkIntegrals(const std::vector<test::BsdfCase>& cases, bool multiscatter, std::initializer_list<double> cosines,
                    std::uint32_t draws) {
    forEachBsdf(cases, multiscatter, [&](const std::string& name, const BsdfDouble& b, const BsdfDouble&) {
        for (const double cosine : cosines) {
            SCOPED_TRACE(fmt::format("{} cosine {}", name, cosine));
            const glm::dvec3 wo = directionAt(cosine, 0.05);
            const BsdfIntegrals integrals = integrateBsdf(b, wo);
            const test::SpreadDraws d = test::drawSpread(b, wo, draws);
            EXPECT_TRUE(d.sound);
            // What the density lacks to 1 is the documented share: draws without a direction, and delta lobes.
            EXPECT_NEAR(integrals.pdf + d.invalid + d.delta, 1, 6e-3);
            // The mean weight is the albedo: weight = f cos / pdf for all draws together.
            const double size = std::max(0.2, d.largest);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(d.mean[c], integrals.albedo()[c], 6e-3 * size);
            for (int c = 0; c < 3; ++c) EXPECT_LE(integrals.albedo()[c], mostEnergy(b));
        }
    });
}

TEST(EveryBsdf, DensityWeightAndEnergyAgreeFull) {
    for (const bool multiscatter : {true, false})
        checkIntegrals(test::fullCases(), multiscatter, {1.0, 0.8, 0.5, 0.25, 0.1, 0.03}, 40000);
}

/// One test a case and direction; all together raise a false alarm once in a thousand runs. [Sidak 67]
void checkDraws(const std::vector<test::BsdfCase>& cases, std::initializer_list<double> cosines, std::uint32_t draws) {
    struct Outcome {
        std::string name;
        double p;
    };
    std::vector<Outcome> outcomes;
    forEachBsdf(cases, true, [&](const std::string& name, const BsdfDouble& b, const BsdfDouble&) {
        if (!reference::hasDensity(b, {0, 0, 1})) return;
        for (const double cosine : cosines) {
            const auto seed = static_cast<std::uint32_t>(outcomes.size());
            outcomes.push_back({fmt::format("{} cosine {}", name, cosine),
                                testBsdfDraws(b, directionAt(cosine, 0.05), draws, seed).p});
        }
    });
    const double level = sidakLevel(1e-3, outcomes.size());
    for (const Outcome& outcome : outcomes) EXPECT_GT(outcome.p, level) << outcome.name;
}

TEST(EveryBsdf, DrawsFollowTheDensityFull) { checkDraws(test::fullCases(), {1.0, 0.9, 0.5, 0.2, 0.05}, 200000); }

// The test has the power it needs: a density 3 % too wide in alpha is refused.
TEST(EveryBsdf, DrawsOfAnotherDensityAreRefused) {
    const reference::LoneBsdf lone(parseBsdfSpec("conductor:alpha=0.3"), false);
    const BsdfDouble right = lone.seenFrom<double>(true);
    BsdfDouble wrong = right;
    wrong.alphaX = 0.33;
    const glm::dvec3 wo = directionAt(0.6, 0.1);
    EXPECT_GT(testBsdfDraws(right, right, wo, 100000, 1).p, 1e-3);
    EXPECT_LT(testBsdfDraws(wrong, right, wo, 100000, 1).p, 1e-6);
}

void checkSingleWeights() {
    forEachBsdf(test::quickCases(), true, [&](const std::string& name, const BsdfDouble& b, const BsdfDouble&) {
        for (std::uint32_t i = 0; i < 200; ++i) {
            const glm::dvec3 wo = directionAt(0.02 + 0.98 * std::fmod(i * 0.618034, 1.0), i * 0.1);
            const test::Spread r = test::spread(i);
            const auto s = reference::sampleBsdf(b, wo, r.uLobe, r.u);
            if (s.pdf == 0 || std::isinf(s.pdf)) continue;
            EXPECT_NEAR(glm::length(s.wi), 1, 1e-12) << name;
            EXPECT_EQ(s.pdf, reference::pdfBsdf(b, wo, s.wi)) << name;
            const glm::dvec3 f = reference::evalBsdf(b, wo, s.wi) * std::abs(s.wi.z);
            EXPECT_NEAR(glm::distance(s.weight * s.pdf, f), 0, 1e-12 * (1 + s.pdf)) << name;
        }
    });
}

void checkReciprocity(std::initializer_list<bool> multiscatters, const std::vector<test::BsdfCase>& cases) {
    for (const bool multiscatter : multiscatters) {
        forEachBsdf(cases, multiscatter, [&](const std::string& name, const BsdfDouble& b, const BsdfDouble& back) {
            // The means of Fresnel in a record are floats: 1e-7.
            EXPECT_LT(reciprocityError(b, back, 2000, 7), 1e-6) << name;
        });
    }
}

// Grazing angles and alpha from 0 to 1: no NaN, nothing negative, no firefly in the weight.
void checkWeights(const std::vector<test::BsdfCase>& cases, std::uint32_t draws) {
    forEachBsdf(cases, true, [&](const std::string& name, BsdfDouble b, const BsdfDouble&) {
        const bool isFacets = b.alphaX > 0 && b.alphaX == b.alphaY;
        for (const double alpha : {0.0, 9e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.4, 1.0}) {
            if (isFacets) b.alphaX = b.alphaY = alpha;
            for (const double cosine : {1.0, 0.5, 0.1, 0.01, 1e-3, 1e-5}) {
                const test::SpreadDraws d = test::drawSpread(b, directionAt(cosine, 0.05), draws);
                EXPECT_TRUE(d.sound) << name << " alpha " << alpha << " cosine " << cosine;
                const bool bounded =
                    b.model != BsdfId::OrenNayar && b.model != BsdfId::Eon && !drawsWithoutVisibility(b);
                if (bounded) {
                    EXPECT_LT(d.largest, 24) << name << " alpha " << alpha << " cosine " << cosine;
                }
            }
            if (!isFacets) break;
        }
    });
}

TEST(EveryBsdf, WeightsStaySmallFull) { checkWeights(test::fullCases(), 40000); }

// The same in the precision of the renderers.
void checkFloats() {
    for (const test::BsdfCase& c : test::quickCases()) {
        const reference::LoneBsdf& lone = test::loneBsdf(c.spec, true);
        for (const bool front : {true, false}) {
            reference::Bsdf<float> b = lone.seenFrom<float>(front);
            const bool isFacets = b.alphaX > 0 && b.alphaX == b.alphaY;
            for (const float alpha : {0.0F, 1e-4F, 1e-3F, 0.1F, 1.0F}) {
                if (isFacets) b.alphaX = b.alphaY = alpha;
                for (const double cosine : {1.0, 0.3, 1e-3, 1e-6}) {
                    const glm::vec3 wo(directionAt(cosine, 0.3));
                    for (std::uint32_t i = 0; i < 300; ++i) {
                        const test::Spread r = test::spread(i);
                        const auto s =
                            reference::sampleBsdf(b, wo, std::min(static_cast<float>(r.uLobe), 0x1.fffffep-1F),
                                                  glm::min(glm::vec2(r.u), glm::vec2(0x1.fffffep-1F)));
                        const auto isSound = [](float v) { return std::isfinite(v) && v >= 0; };
                        EXPECT_TRUE(isSound(s.weight.x) && isSound(s.weight.y) && isSound(s.weight.z) && s.pdf >= 0)
                            << c.spec << " alpha " << alpha << " cosine " << cosine << " draw " << i;
                        const glm::vec3 any(directionAt(std::max(1e-6, r.u.x), r.u.y));
                        const glm::vec3 f = reference::evalBsdf(b, wo, any);
                        EXPECT_TRUE(isSound(f.x) && isSound(f.y) && isSound(f.z) &&
                                    isSound(reference::pdfBsdf(b, wo, any)))
                            << c.spec << " alpha " << alpha << " cosine " << cosine << " eval " << i;
                    }
                }
                if (!isFacets) break;
            }
        }
    }
}

TEST(EveryBsdf, IsReciprocalFull) { checkReciprocity({true, false}, test::fullCases()); }

// One test, since the tables of the models are made once a process.
TEST(EveryBsdf, OwesDensityWeightReciprocityAndEnergy) {
    checkIntegrals(test::quickCases(), true, {0.9, 0.15}, 8192);
    checkDraws(test::quickCases(), {0.8, 0.2}, 40000);
    checkReciprocity({true}, test::quickCases());
    checkSingleWeights();
    checkWeights(test::quickCases(), 500);
    checkFloats();
}

}  // namespace
}  // namespace vkpt
