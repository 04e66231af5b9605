// Weights of the two ways of finding light, and directions drawn without regard to a BSDF.
#include "reference/heuristic.h"

#include <gtest/gtest.h>

#include <limits>

#include "reference/hemisphere.h"
#include "scene/render_options.h"

namespace vkpt::reference {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(MisWeight, OfBothTechniquesIsOneTogether) {
    for (const float beta : {0.0F, 0.5F, 1.0F, 2.0F, 3.0F, 64.0F})
        for (const float p : {1e-20F, 0.3F, 5.0F, 1e20F})
            for (const float q : {1e-20F, 0.25F, 7.0F, 1e20F})
                for (const float n : {1.0F, 4.0F})
                    EXPECT_NEAR(misWeight(n, p, 3, q, beta) + misWeight(3, q, n, p, beta), 1, 1e-6)
                        << beta << ' ' << p << ' ' << q;
}

TEST(MisWeight, EqualsWorkedValues) {
    EXPECT_FLOAT_EQ(misWeight(1, 3, 1, 1, 1), 0.75F);
    EXPECT_FLOAT_EQ(misWeight(1, 3, 1, 1, 2), 0.9F);
    EXPECT_FLOAT_EQ(misWeight(2, 3, 3, 4, 1), 1.0F / 3);
    EXPECT_FLOAT_EQ(misWeight(2, 3, 3, 4, 2), 0.2F);
    EXPECT_FLOAT_EQ(misWeight(1, 2, 1, 1, 3), 8.0F / 9);
    EXPECT_EQ(misWeight(1, kInfinity, 1, 1, 2), 1);
    for (const float beta : {0.0F, 1.0F, 2.0F}) {
        EXPECT_EQ(misWeight(1, 1, 1, 0, beta), 1) << "what the other never finds is mine";
        EXPECT_EQ(misWeight(1, 1, 0, 5, beta), 1) << "the other draws nothing";
    }
}

Heuristic heuristicOf(std::uint32_t strategy, IntegratorId integrator = IntegratorId::Path) {
    RenderParams params = defaultParams();
    params.strategy = strategy;
    params.integrator = static_cast<std::uint32_t>(integrator);
    params.bsdfSamples = 3;
    params.lightSamples = 2;
    return Heuristic(params);
}

TEST(Heuristic, StrategiesCountLightOnce) {
    const Heuristic balance = heuristicOf(kStrategyMisBalance), power = heuristicOf(kStrategyMisPower);
    EXPECT_FLOAT_EQ(balance.ofEmission(3, true, 1), 0.75F);
    EXPECT_FLOAT_EQ(power.ofEmission(3, true, 1), 0.9F);
    EXPECT_FLOAT_EQ(power.ofLight(3, 1), 0.9F);
    const Heuristic chance = heuristicOf(kStrategyBsdf), light = heuristicOf(kStrategyLight);
    EXPECT_EQ(chance.lightSamples(), 0U);
    EXPECT_EQ(chance.ofEmission(3, true, 1), 1);
    EXPECT_EQ(light.ofLight(3, 1), 1);
    EXPECT_EQ(light.ofEmission(3, true, 1), 0);
    EXPECT_EQ(light.ofEmission(3, true, 0), 1) << "in the plane of a light";
    EXPECT_EQ(light.ofEmission(3, false, 0), 1) << "no light sample finds it";
    for (const Heuristic& h : {balance, power, chance, light}) {
        EXPECT_EQ(h.ofEmission(kInfinity, true, 1), 1) << "after a mirror";
        EXPECT_EQ(h.ofEmission(0.5F, false, 0), 1);
        EXPECT_EQ(h.bsdfSamples(), 1U) << "but in integrator direct";
    }
}

TEST(Heuristic, OfIntegratorDirectCountsSamples) {
    const Heuristic h = heuristicOf(kStrategyMisBalance, IntegratorId::Direct);
    EXPECT_EQ(h.bsdfSamples(), 3U);
    EXPECT_EQ(h.lightSamples(), 2U);
    EXPECT_FLOAT_EQ(h.ofEmission(1, true, 1.5F), 0.5F);
    EXPECT_FLOAT_EQ(h.ofLight(1.5F, 1), 0.5F);
}

TEST(Hemisphere, DirectionsHaveTheirDensity) {
    constexpr int kGrid = 256;
    for (const std::uint32_t kind : {kHemisphereUniform, kHemisphereCosine}) {
        double cosines = 0;
        glm::dvec3 mean(0);
        for (int i = 0; i < kGrid * kGrid; ++i) {
            const glm::dvec2 u((i % kGrid + 0.5) / kGrid, (i / kGrid + 0.5) / kGrid);
            const glm::dvec3 wi = sampleHemisphere(kind, u);
            ASSERT_NEAR(glm::length(wi), 1, 1e-12);
            cosines += wi.z / hemispherePdf(kind, wi) / kGrid / kGrid;
            mean += wi / double(kGrid) / double(kGrid);
        }
        EXPECT_NEAR(cosines, kPiOf<double>, 1e-9) << "what a hemisphere of light gives a surface";
        const double height = kind == kHemisphereUniform ? 0.5 : 2.0 / 3;
        EXPECT_LT(glm::distance(mean, glm::dvec3(0, 0, height)), 1e-3);
        EXPECT_EQ(hemispherePdf(kind, glm::dvec3(0, 0.6, -0.8)), 0);
    }
}

}  // namespace
}  // namespace vkpt::reference
