// Integrator direct: several samples of each kind at the first surface.
#include <gtest/gtest.h>

#include "estimate.h"

namespace vkpt {
namespace {

using namespace test;

/// A glossy plane under a square lamp: both kinds of samples matter.
SceneArrays glossyScene() {
    SceneBuilder builder;
    builder.quad(builder.material(metal(glm::vec3(0.8F), 0.45F)), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    builder.quad(builder.material(emitter(glm::vec3(1))), {0.2F, 0.5F, 1}, {1, 0, 0}, {0, -1, 0});
    return builder.build();
}

RenderOptions directView(std::uint32_t spp) {
    RenderOptions options = viewAlongZ(1, 0.01F, spp, 1, 0.5F);
    options.params.integrator = static_cast<std::uint32_t>(IntegratorId::Direct);
    return options;
}

RenderOptions withSamples(RenderOptions options, std::uint32_t bsdf, std::uint32_t light) {
    options.params.bsdfSamples = bsdf;
    options.params.lightSamples = light;
    return options;
}

bool sameSums(const Film& a, const Film& b) {
    return std::ranges::equal(a.sums, b.sums, [](const FilmSums& x, const FilmSums& y) {
        return x.red == y.red && x.green == y.green && x.blue == y.blue;
    });
}

TEST(Direct, OfOneSampleEachIsAPathOfOneBounce) {
    const SceneArrays scene = glossyScene();
    RenderOptions direct = directView(64), path = direct;
    path.params.integrator = static_cast<std::uint32_t>(IntegratorId::Path);
    path.params.rrMode = kRouletteOff;
    for (const NamedId& strategy : kEveryStrategy) {
        direct.params.strategy = path.params.strategy = strategy.id;
        EXPECT_TRUE(sameSums(renderReference(scene, direct), renderReference(scene, path))) << strategy.name;
    }
    path.params.strategy = kStrategyMisPower;
    EXPECT_FALSE(sameSums(renderReference(scene, direct), renderReference(scene, path))) << "the last was light";
}

TEST(Direct, EveryNumberOfSamplesEstimatesTheSame) {
    const SceneArrays scene = glossyScene();
    const Estimate truth = estimate(scene, withSamples(directView(2048), 1, 1), 16);
    const std::uint32_t counts[][2] = {{1, 1}, {4, 1}, {1, 3}, {5, 0}, {0, 5}, {3, 4}};
    for (const auto& [bsdf, light] : counts)
        for (const NamedId& strategy : kEveryStrategy) {
            if (strategy.id == kStrategyBsdf && bsdf == 0) continue;  // samples nothing
            if (strategy.id == kStrategyLight && light == 0) continue;
            SCOPED_TRACE(std::string(strategy.name) + ' ' + std::to_string(bsdf) + ' ' + std::to_string(light));
            RenderOptions options = withSamples(directView(128), bsdf, light);
            options.params.strategy = strategy.id;
            const Estimate e = estimate(scene, options, 32);
            EXPECT_NEAR(e.mean, truth.mean, 3 * std::hypot(e.standardError, truth.standardError));
            EXPECT_LT(e.standardError, 0.02 * truth.mean);
        }
}

TEST(Direct, MoreSamplesMakeLessNoise) {
    const SceneArrays scene = glossyScene();
    RenderOptions options = directView(16);
    options.sampler = {SamplerId::Random, ScrambleId::None};
    const Estimate one = estimate(scene, withSamples(options, 1, 1), 64);
    const Estimate sixteen = estimate(scene, withSamples(options, 16, 16), 64);
    EXPECT_NEAR(one.standardError / sixteen.standardError, 4, 1.5) << "independent samples: the root of 16";
}

TEST(Direct, EmissionAlphaAndLayersCountOnce) {
    SceneBuilder builder;
    Material glowing = metal(glm::vec3(0.5F), 0.4F);
    glowing.emissive = glm::vec3(2);
    builder.quad(builder.material(glowing), {-1, -9, 0}, {1, 0, 0}, {0, 18, 0});  // the left half of the view
    const SceneArrays scene = builder.build();
    RenderOptions options = withSamples(directView(16), 4, 3);
    options.params.right.x = options.params.up.y = 1;
    options.aovs.add(Aov::Depth);
    const Film film = renderReference(scene, options);
    const glm::dvec4 mean = meanOf(film);
    EXPECT_NEAR(mean.r, 1, 1e-6);
    EXPECT_EQ(film.sums[0].green.w, 8U);
    EXPECT_EQ(film.sums[0].red.w, 16U) << "the background is opaque";
    EXPECT_EQ(film.layers[film.layout.firstWord(Layer::Depth)].y, 8U * 0x8000U) << "eight times half a metre";
}

TEST(Direct, DepthsBeyondOneCountAsOne) {
    SceneBuilder builder;  // in a room light would go on
    builder.roomAround(builder.material(metal(glm::vec3(0.8F), 0.6F)), glm::vec3(0), 3);
    builder.quad(builder.material(emitter(glm::vec3(2))), {-0.5F, 0.5F, 2}, {1, 0, 0}, {0, -1, 0});
    const SceneArrays scene = builder.build();
    RenderOptions options = withSamples(directView(64), 2, 1);
    const Film one = renderReference(scene, options);
    options.params.maxDepth = 8;
    EXPECT_TRUE(sameSums(one, renderReference(scene, options)));
    EXPECT_GT(meanOf(one).r, 0);
}

TEST(Direct, DepthZeroIsEmissionAlone) {
    RenderOptions options = withSamples(directView(16), 4, 3);
    options.params.maxDepth = 0;
    EXPECT_EQ(meanOf(renderReference(glossyScene(), options)).r, 0);
}

}  // namespace
}  // namespace vkpt
