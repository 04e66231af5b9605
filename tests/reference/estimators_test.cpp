// Light transport in closed form on the reference, and what --clamp-indirect cuts.
#include "closed_forms.h"

namespace vkpt {
namespace {

using namespace test;

TEST(EveryEstimator, DiscLightOverAPlane) { closed_forms::discLightOverAPlane(onReference); }
TEST(EveryEstimator, SphereInsideASphere) { closed_forms::sphereInsideASphere(onReference); }
TEST(EveryEstimator, PunctualLightsAreForLightSamplesAlone) {
    closed_forms::punctualLightsAreForLightSamplesAlone(onReference);
}
TEST(EveryEstimator, SpotFallsOffBetweenItsCones) { closed_forms::spotFallsOffBetweenItsCones(onReference); }
TEST(EveryEstimator, AMirrorShowsALamp) { closed_forms::aMirrorShowsALamp(onReference); }
TEST(EveryEstimator, FurnaceShowsTheAlbedo) { closed_forms::furnaceShowsTheAlbedo(onReference); }
TEST(EveryEstimator, FurnaceOfEveryIntegrator) { closed_forms::furnaceOfEveryIntegrator(onReference); }
TEST(EveryEstimator, RouletteKeepsTheMean) { closed_forms::rouletteKeepsTheMean(onReference); }

// A pane over the ground that turns its back on it: however light is looked for, none arrives.
TEST(EveryEstimator, GlassShinesInFrontAlone) {
    Material glass = bsdfMaterial("dielectric");
    glass.emissive = glm::vec3(5);
    for (const bool facesTheGround : {false, true}) {
        SceneBuilder builder = closed_forms::groundOf(bsdfMaterial("lambert:color=0.6"));
        const glm::vec3 x(2, 0, 0), y(0, 2, 0);
        builder.quad(builder.material(glass), {-1, -1, 1}, facesTheGround ? y : x, facesTheGround ? x : y);
        const SceneArrays scene = builder.build();
        closed_forms::forEveryEstimator(viewAlongZ(1, 1e-3F, 64, 1, 0.5F), [&](const RenderOptions& options) {
            const double found = closed_forms::redOf(onReference, scene, options);
            EXPECT_EQ(found > 0, facesTheGround) << found;
        });
    }
}

TEST(LongPaths, KeepTheirEnergyForAThousandBounces) { closed_forms::energyOfAThousandBounces(onReference); }

// Each contribution of two and more scatterings is cut, no other.
TEST(ClampIndirect, CutsWhatWasScatteredTwice) {
    Material glowing = metal(glm::vec3(1), 0);
    glowing.emissive = {1, 0.5F, 0.25F};
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    RenderOptions options = viewAlongZ(4, 1, 4, 5, 1);
    const auto check = [&](float most, double factor) {
        options.params.clampIndirect = most;
        const glm::dvec3 mean = meanOf(renderReference(scene, options));
        EXPECT_LT(glm::distance(mean, (2 + 4 * factor) * glm::dvec3(1, 0.5, 0.25)), 1e-3) << most;
    };
    check(0, 1);
    check(2, 1);
    check(0.5F, 0.5);  // the hue stays
    check(0.125F, 0.125);
}

TEST(ClampIndirect, CutsLightSamplesFromTheSecondSurfaceOn) {
    SceneBuilder builder = closed_forms::groundOf(metal(glm::vec3(1), 0));  // a mirror that shows a lit ceiling
    builder.quad(builder.material(bsdfMaterial("lambert:color=0.5")), {-9, -9, 6}, {0, 18, 0}, {18, 0, 0});
    PunctualLight light;
    light.intensity = glm::vec3(40);
    light.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(0.5F, 0, 4));
    const SceneArrays scene = builder.light(light).build();
    RenderOptions options = viewAlongZ(1, 1e-3F, 4, 2, 3);
    const double open = meanOf(renderReference(scene, options)).r;
    ASSERT_GT(open, 1);
    options.params.clampIndirect = 0.75F;
    EXPECT_NEAR(meanOf(renderReference(scene, options)).r, 0.75, 1e-5);
    options.params.eye.z = 5;
    options.params.forward.z = 1;  // the ceiling itself: scattered once
    EXPECT_NEAR(meanOf(renderReference(scene, options)).r, open, 0.02 * open);
}

}  // namespace
}  // namespace vkpt
