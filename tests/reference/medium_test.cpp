// Absorption inside of dielectrics, by the law of Beer and Lambert.
#include "reference/medium.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "estimate.h"

namespace vkpt {
namespace {

using namespace test;

/// Glass, or what does not bend light where the index is 1, that leaves (0.5, 0.25, 1) after half a metre.
Material tinted(float index, float alpha = 0) {
    Material m = bsdfMaterial("dielectric:attenuation_color=0.5/0.25/1,attenuation_distance=0.5");
    m.bsdf->eta = glm::vec3(index);
    m.bsdf->alpha = glm::vec2(alpha);
    return m;
}
const glm::dvec3 kSigma(2 * std::log(2.0), 4 * std::log(2.0), 0);

glm::dvec3 left(double distance) { return glm::exp(-kSigma * distance); }

/// A sheet 0 <= z <= thickness without end.
void addSlab(SceneBuilder& builder, std::uint32_t material, float thickness) {
    builder.quad(material, {-9, -9, thickness}, {18, 0, 0}, {0, 18, 0});
    builder.quad(material, {-9, -9, 0}, {0, 18, 0}, {18, 0, 0});
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

// Without a change of index rays go straight on: exp(-sigma d) along their way, whatever the angle.
TEST(Medium, SlabOfEqualIndexLeavesExpOfMinusSigmaD) {
    SceneBuilder builder;
    addSlab(builder, builder.material(tinted(1)), 0.75F);
    const SceneArrays scene = builder.build(glm::vec3(1));
    EXPECT_TRUE(scene.features.media);
    for (const float cosine : {1.0F, 0.6F, 0.25F}) {
        const glm::dvec3 mean = meanOf(renderReference(scene, viewAtAngle(cosine, 0.5F, 4, 4)));
        expectNear(mean, left(0.75 / double{cosine}), 2e-5);
    }
}

// Light bounces between the two faces of glass: all orders, summed.
TEST(Medium, GlassSlabInUniformLightSumsAllItsReflections) {
    SceneBuilder builder;
    addSlab(builder, builder.material(tinted(1.5F)), 0.5F);
    const EnvironmentMap white = constantEnvironment(glm::vec3(1));
    const SceneArrays scene = builder.build(&white);
    RenderOptions options = viewAlongZ(8, 0.5F, 64, 60);
    for (const NamedId& strategy : kEveryStrategy) {
        options.params.strategy = strategy.id;
        const auto estimates = estimateRgb(scene, options, 8);
        for (int channel = 0; channel < 3; ++channel) {
            const double F = 0.04, a = left(0.5)[channel];
            const double passes = (1 - F) * (1 - F) * a / (1 - F * F * a * a);
            expectEstimates(estimates[static_cast<std::size_t>(channel)], F + passes + F * a * passes, 1e-4);
        }
    }
}

// A lamp that is in the same block as a wall: both ways are absorbed on, also by light samples.
TEST(Medium, LightSamplesAreAbsorbedOnTheirWay) {
    SceneBuilder builder;
    const std::uint32_t block = builder.material(tinted(1));
    addSlab(builder, block, 2);
    builder.quad(builder.material(bsdfMaterial("lambert:color=0.8")), {-9, -9, 0.5F}, {18, 0, 0}, {0, 18, 0});
    PunctualLight lamp;
    lamp.intensity = glm::vec3(5);
    lamp.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(1.2F, 0, 1.1F));
    const double distance = std::hypot(1.2, 0.6);
    const glm::dvec3 truth = 0.8 / 3.14159265358979 * 5 * 0.6 / std::pow(distance, 3) * left(1.5 + distance);
    const SceneArrays scene = builder.light(lamp).build();
    for (const std::uint32_t strategy : {kStrategyMisPower, kStrategyLight}) {
        RenderOptions options = viewAlongZ(1, 1e-4F, 4, 3);
        options.params.strategy = strategy;
        expectNear(meanOf(renderReference(scene, options)), truth, 1e-5);
    }
}

// Strategies agree on a lamp that has a surface, inside of a block and through a rough boundary.
TEST(Medium, StrategiesAgreeInsideAndThroughRoughGlass) {
    for (const bool rough : {false, true}) {
        SceneBuilder builder;
        const std::uint32_t block = builder.material(rough ? tinted(1.3F, 0.4F) : tinted(1));
        addSlab(builder, block, 2);
        builder.quad(builder.material(bsdfMaterial("lambert:color=0.8")), {-9, -9, 0.5F}, {18, 0, 0}, {0, 18, 0});
        builder.quad(builder.material(emitter(glm::vec3(4))), {0.5F, 1, 1.5F}, {2, 0, 0}, {0, -2, 0});
        const SceneArrays scene = builder.build();
        RenderOptions options = viewAlongZ(1, 1e-2F, 512, 4);
        const Estimate reference = estimate(scene, options, 16);
        EXPECT_LT(reference.standardError, 0.01 * reference.mean);
        for (const NamedId& strategy : kEveryStrategy) {
            SCOPED_TRACE(std::string(rough ? "rough, " : "smooth, ") + strategy.name);
            options.params.strategy = strategy.id;
            options.params.seed = 0;
            options.sampler = {SamplerId::Random, ScrambleId::None};
            const Estimate e = estimate(scene, options, 16);
            EXPECT_NEAR(e.mean, reference.mean, 3 * std::hypot(e.standardError, reference.standardError));
        }
    }
}

// A surface through which nothing comes back out: what goes on for ever is lost where there is absorption at all.
TEST(Medium, EndlessWaysLeaveWhatIsNotAbsorbed) {
    SceneBuilder builder;
    builder.quad(builder.material(tinted(1)), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    expectNear(meanOf(renderReference(builder.build(glm::vec3(1)), viewAlongZ(2, 1, 4, 4))), {0, 0, 1}, 1e-6);
    builder = SceneBuilder();
    builder.quad(builder.material(tinted(1)), {-9, -9, 0}, {0, 18, 0}, {18, 0, 0});  // met from behind: leads outside
    expectNear(meanOf(renderReference(builder.build(glm::vec3(1)), viewAlongZ(2, 1, 4, 4))), glm::dvec3(1), 1e-6);
}

TEST(Medium, ClearGlassIsNoMedium) {
    SceneBuilder builder;
    addSlab(builder, builder.material(bsdfMaterial("dielectric:attenuation_distance=0.01")), 1);
    EXPECT_FALSE(builder.build().features.media);
    EXPECT_EQ(reference::transmittance(builder.build(), 0, std::numeric_limits<float>::infinity()), glm::vec3(1));
}

}  // namespace
}  // namespace vkpt
