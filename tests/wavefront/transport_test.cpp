// Every integrator, strategy, hemisphere, pixel filter and camera against the reference: kernel by kernel from the
// device's own state, and as films of the same random numbers.
#include "reference/path.h"
#include "reference/render.h"
#include "registry.h"
#include "scene/camera.h"
#include "scene/pixel_filter.h"
#include "verify/stages/walk.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

/// What a render chooses; the defaults are those of the command line.
struct Choice {
    IntegratorId integrator = IntegratorId::Path;
    std::uint32_t strategy = kStrategyMisPower, hemisphere = kHemisphereBsdf;
    std::uint32_t filter = kFilterBox, projection = kProjectionPerspective;
    float lens = 0, beta = 2, clamp = 0;
};

RenderOptions optionsOf(const Choice& choice) {
    RenderOptions options = makeOptions(40, 30, 1);
    RenderParams& p = options.params;
    p.integrator = static_cast<std::uint32_t>(choice.integrator);
    p.strategy = choice.strategy;
    p.hemisphere = choice.hemisphere;
    p.beta = choice.beta;
    p.clampIndirect = choice.clamp;
    p.pixelFilter = choice.filter;
    for (const FilterInfo& filter : kFilters)
        if (filter.id == choice.filter) p.filterRadius = filter.radius;
    setProjection(p, choice.projection, 6);
    p.lensRadius = choice.lens;
    p.focusDistance = 5;
    p.aoDistance = 1.5F;
    p.bsdfSamples = 2;
    p.lightSamples = 3;
    p.maxDepth = 4;
    return options;
}

std::string describe(const Choice& c) {
    return fmt::format("{}, strategy {}, beta {}, hemisphere {}, filter {}, projection {}, lens {}, clamp {}",
                       kIntegrators[static_cast<std::size_t>(c.integrator)].name, c.strategy, c.beta, c.hemisphere,
                       c.filter, c.projection, c.lens, c.clamp);
}

void expectParity(const SceneArrays& scene, const Choice& choice) {
    SCOPED_TRACE(describe(choice));
    const RenderOptions options = optionsOf(choice);
    WavefrontRenderer renderer(scene, options, makeConfig());
    StageWalk walk(scene, options, "scene");
    walk.run(renderer, 0, options.params.width * options.params.height);
    walk.finish();
    for (std::size_t stage = 0; stage < kStages; ++stage) {
        const auto& wrong = walk.findings(static_cast<Stage>(stage)).disagreement();
        EXPECT_FALSE(wrong) << kStageNames[stage] << ", " << wrong->quantity << ": " << wrong->what << "\n"
                            << wrong->where;
    }
    EXPECT_EQ(renderer.validationMessages(), 0U);
    if (choice.integrator == IntegratorId::Cost) return;  // each renderer counts its own search
    WavefrontStats stats;
    const Film film = renderer.render({}, &stats), expected = renderReference(scene, options);
    EXPECT_EQ(stats.stages.front().items, stats.paths * reference::PathTracer(scene, options).rounds());
    EXPECT_LE(divergedShare(film, expected), 0.01);
    EXPECT_EQ(film.refused + expected.refused, 0U);
    for (std::size_t i = 0; i < film.sums.size(); ++i) ASSERT_EQ(film.sums[i].red.w, expected.sums[i].red.w) << i;
}

/// The lamps under a sky: its kernels are soon compiled.
SceneArrays makeLitFloor() {
    SceneArrays scene = flatten(makeLamps());
    finishUnderNoise(scene, 7);
    return scene;
}

TEST(Transport, StrategiesHemispheresFiltersAndCamerasEqualTheReference) {
    const SceneArrays scene = makeLitFloor();
    expectParity(scene, {.strategy = kStrategyMisBalance,
                         .hemisphere = kHemisphereCosine,
                         .filter = kFilterMitchell,
                         .projection = kProjectionPanorama,
                         .clamp = 0.05F});
    expectParity(scene, {.strategy = kStrategyLight,
                         .hemisphere = kHemisphereUniform,
                         .filter = kFilterGaussian,
                         .projection = kProjectionOrthographic,
                         .lens = 0.2F});
    expectParity(scene, {.strategy = kStrategyBsdf, .filter = kFilterBlackmanHarris, .lens = 0.1F});
}

TEST(Transport, IntegratorsEqualTheReference) {
    const SceneArrays everything = makeEverything(), floor = makeLitFloor();
    expectParity(everything, {.integrator = IntegratorId::Direct, .filter = kFilterTent, .beta = 1.5F});
    for (const IntegratorInfo& integrator : kIntegrators)
        if (integrator.id != IntegratorId::Path && integrator.id != IntegratorId::Direct)
            expectParity(floor, {.integrator = integrator.id});
}

TEST(Transport, FullIntegratorsOfEveryBsdfEqualTheReference) {
    const SceneArrays scene = makeBsdfPatches(true);
    for (const IntegratorInfo& integrator : kIntegrators)
        expectParity(scene, {.integrator = integrator.id,
                             .hemisphere = kHemisphereUniform,
                             .filter = kFilterMitchell,
                             .projection = kProjectionPanorama});
}

TEST(Transport, FullStrategiesUnderEveryHemisphereEqualTheReference) {
    const SceneArrays everything = makeEverything(true), patches = makeBsdfPatches(true);
    for (const std::uint32_t strategy : {kStrategyMisPower, kStrategyMisBalance, kStrategyBsdf, kStrategyLight})
        for (const std::uint32_t hemisphere : {kHemisphereBsdf, kHemisphereUniform, kHemisphereCosine}) {
            const Choice path{.strategy = strategy, .hemisphere = hemisphere, .lens = 0.1F};
            Choice direct = path;
            direct.integrator = IntegratorId::Direct;
            expectParity(everything, path);
            expectParity(everything, direct);
            expectParity(patches, path);
        }
}

TEST(Transport, FullFiltersAndCamerasEqualTheReference) {
    const SceneArrays scene = makeEverything();
    for (const FilterInfo& filter : kFilters)
        for (const std::uint32_t projection : {kProjectionPerspective, kProjectionOrthographic, kProjectionPanorama})
            for (const float lens : {0.0F, 0.3F})
                expectParity(scene, {.filter = filter.id, .projection = projection, .lens = lens});
}

}  // namespace
}  // namespace vkpt
