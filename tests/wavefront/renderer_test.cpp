// The renderer end to end: what must not change the image does not, to the bit.
#include <cstring>

#include "base/error.h"
#include "bvh/build.h"
#include "reference/render.h"
#include "registry.h"
#include "verify/inputs/scenes.h"
#include "wavefront/kernels.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

bool fetchFormsAgree(const SceneArrays& arrays, const RenderOptions& options) {
    WavefrontConfig config = makeConfig();
    config.fetch = WavefrontConfig::Fetch::Texel;
    const Film texel = renderWith(arrays, options, config);
    config.fetch = WavefrontConfig::Fetch::Storage;
    return isSame(texel, renderWith(arrays, options, config));
}

TEST(Renderer, FetchFormsGiveTheSameFilmToTheBit) {
    for (const bool instances : {false, true}) {
        const SceneArrays arrays = makeEverything(instances);
        ASSERT_EQ(arrays.features.instances, instances);
        EXPECT_TRUE(fetchFormsAgree(arrays, makeOptions(48, 32, 4)));
    }
}

// Where there is a list, storage buffers still hold the tree, and shadow rays have a stage of their own.
TEST(Renderer, ListAndTreeGiveTheSameFilmToTheBit) {
    const SceneArrays arrays = makeArrays(makeLamps());
    RenderOptions options = makeOptions(48, 32, 16);
    ASSERT_EQ(listTriangles(arrays, options.params.integrator), arrays.triangles.size());
    EXPECT_TRUE(fetchFormsAgree(arrays, options));
    options.params.clampIndirect = 0.2F;
    EXPECT_TRUE(fetchFormsAgree(arrays, options)) << "clamped";
    options.params.clampIndirect = 0;
    for (const IntegratorId integrator : {IntegratorId::Direct, IntegratorId::Ao, IntegratorId::LightProbability}) {
        options.params.integrator = static_cast<std::uint32_t>(integrator);
        options.params.bsdfSamples = 2;
        options.params.lightSamples = 3;
        EXPECT_TRUE(fetchFormsAgree(arrays, options)) << "integrator " << options.params.integrator;
    }
}

TEST(Renderer, ShallowAndDeepStacksGiveTheSameFilmToTheBit) {
    for (const bool instances : {false, true}) {
        SceneArrays arrays = makeEverything(instances);
        const RenderOptions options = makeOptions(48, 32, 4);
        const Film film = renderWith(arrays, options, makeConfig());
        arrays.bvhDepth = kMaxStackEntries + 1;
        EXPECT_TRUE(isSame(film, renderWith(arrays, options, makeConfig())));
    }
}

TEST(Renderer, OnlyFewTrianglesAreListed) {
    const std::uint32_t path = makeOptions(1, 1, 1).params.integrator;
    EXPECT_EQ(listTriangles(makeEverything(), path), 0U) << "alpha";
    EXPECT_EQ(listTriangles(makeEverything(true), path), 0U) << "instances";
    SceneArrays arrays = makeFurnace();
    EXPECT_EQ(listTriangles(arrays, static_cast<std::uint32_t>(IntegratorId::Cost)), 0U) << "which shows the tree";
    EXPECT_EQ(listTriangles(arrays, path), arrays.triangles.size());
    arrays.triangles.resize(kListMax + 1);
    EXPECT_EQ(listTriangles(arrays, path), 0U) << "too many";
}

TEST(Renderer, SlotsBatchesAndCompactionDoNotChangeTheFilm) {
    const SceneArrays arrays = makeEverything();
    const RenderOptions options = makeOptions(48, 32, 6);
    WavefrontStats stats;
    const Film film = renderWith(arrays, options, makeConfig(), &stats);
    EXPECT_EQ(stats.batches, 1U);
    EXPECT_EQ(stats.paths, 48U * 32 * 6);
    for (const std::uint32_t paths : {64U, 1000U, 48U * 32 * 2, 5000U}) {
        SCOPED_TRACE(paths);
        WavefrontConfig config = makeConfig();
        config.pathsInFlight = paths;
        EXPECT_TRUE(isSame(film, renderWith(arrays, options, config, &stats)));
        EXPECT_GT(stats.batches, 1U);
        EXPECT_EQ(stats.paths, 48U * 32 * 6);
    }
    WavefrontConfig config = makeConfig();
    config.ballot = false;
    EXPECT_TRUE(isSame(film, renderWith(arrays, options, config)));
    config.timings = true;
    EXPECT_TRUE(isSame(film, renderWith(arrays, options, config)));
}

void expectRangesToAddUp(SamplerId sampler) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = makeOptions(24, 20, 16);
    options.sampler = sampler;
    WavefrontRenderer renderer(arrays, options, makeConfig());
    const Film whole = renderer.render({});
    renderer.select(options.params.seed, 0, 8);
    Film sum = renderer.render({});
    renderer.select(options.params.seed, 8, 16);
    addFilm(sum, renderer.render({}));
    EXPECT_TRUE(isSame(sum, whole)) << samplerName(sampler);
}

TEST(Renderer, RangesOfSamplesAddUpToTheWhole) {
    for (const SamplerId sampler : {SamplerId::Random, SamplerId::Sobol, SamplerId::Zsobol})
        expectRangesToAddUp(sampler);
}

TEST(Renderer, FullRangesOfSamplesAddUpToTheWholeWithEverySampler) {
    for (const SamplerInfo& sampler : kSamplers) expectRangesToAddUp(sampler.id);
}

TEST(Renderer, RendersAgainWithTheSameResult) {
    const SceneArrays arrays = makeEverything();
    WavefrontRenderer renderer(arrays, makeOptions(24, 20, 4), makeConfig());
    const Film first = renderer.render({});
    EXPECT_TRUE(isSame(first, renderer.render({})));
}

TEST(Renderer, SelectedSamplesAreThoseOfAFreshRenderer) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = makeOptions(24, 20, 4);
    WavefrontRenderer renderer(arrays, options, makeConfig());
    const Film first = renderer.render({});
    options.params.seed = 77;
    options.sampleBegin = 1;
    options.sampleEnd = 3;
    renderer.select(77, 1, 3);
    EXPECT_TRUE(isSame(renderer.render({}), renderWith(arrays, options)));
    renderer.select(makeOptions(24, 20, 4).params.seed, 0, 4);
    EXPECT_TRUE(isSame(renderer.render({}), first));
}

TEST(Renderer, ObservedBatchesGiveTheSumsOfTheFilm) {
    const SceneArrays arrays = makeEverything();
    const RenderOptions options = makeOptions(24, 20, 4);
    WavefrontRenderer renderer(arrays, options, makeConfig());
    const Film film = renderer.render({});
    std::vector<Stage> stages;
    std::uint32_t rays = 0;
    const auto [sums, layers] = renderer.observe(24, 48, [&](const StageSnapshot& snapshot) {
        stages.push_back(snapshot.stage);
        if (snapshot.stage == Stage::Generate) rays = snapshot.queueSize(0, Queue::Ray);
        if (snapshot.stage != Stage::Intersect) return;
        const std::uint32_t b = snapshot.batch.bounce;
        EXPECT_EQ(snapshot.queue(b, Queue::Hit).size() + snapshot.queue(b, Queue::Miss).size(),
                  snapshot.queueSize(b, Queue::Ray));
    });
    EXPECT_EQ(rays, 48U * 4);
    EXPECT_EQ(stages.front(), Stage::Generate);
    EXPECT_EQ(stages.back(), Stage::Accumulate);
    EXPECT_EQ(stages.size(), 2 + 4 * 6 - 1U) << "six bounces, the last without a shadow stage";
    ASSERT_EQ(sums.size(), 48U);
    EXPECT_EQ(std::memcmp(sums.data(), film.sums.data() + 24, sums.size() * sizeof(FilmSums)), 0);
    EXPECT_TRUE(layers.empty());
    EXPECT_TRUE(isSame(renderer.render({}), film)) << "and change nothing afterwards";
    EXPECT_THROW((void)renderer.observe(24, 24 * 20, {}), Error) << "beyond the film";
}

TEST(Renderer, ObserversSeeShadowRaysThatAreTracedInsideOtherwise) {
    const SceneArrays arrays = makeArrays(makeLamps());
    WavefrontRenderer renderer(arrays, makeOptions(24, 20, 4), makeConfig());
    const Film film = renderer.render({});
    std::uint32_t shadows = 0;
    const auto [sums, layers] = renderer.observe(240, 48, [&](const StageSnapshot& snapshot) {
        if (snapshot.stage == Stage::Shadow) shadows += snapshot.queueSize(snapshot.batch.bounce, Queue::Shadow);
    });
    EXPECT_GT(shadows, 48U);
    ASSERT_EQ(sums.size(), 48U);
    EXPECT_EQ(std::memcmp(sums.data(), film.sums.data() + 240, sums.size() * sizeof(FilmSums)), 0);
    EXPECT_TRUE(isSame(renderer.render({}), film));
}

struct Length {
    std::uint32_t maxDepth, rrMode;
};

void expectOneSampleEqualsReference(bool instances, const std::vector<Length>& lengths) {
    const SceneArrays arrays = makeEverything(instances);
    for (const Length& length : lengths) {
        SCOPED_TRACE(testing::Message() << "depth " << length.maxDepth << " roulette " << length.rrMode
                                        << (instances ? " with instances" : ""));
        RenderOptions options = makeOptions(64, 48, 1);
        options.params.maxDepth = length.maxDepth;
        options.params.rrMode = length.rrMode;
        options.params.rrDepth = 1;
        options.params.rrFixed = 0.75F;
        const Film film = renderWith(arrays, options), reference = renderReference(arrays, options);
        EXPECT_LE(divergedShare(film, reference), 0.01);
        for (std::size_t i = 0; i < film.sums.size(); ++i)
            ASSERT_EQ(film.sums[i].red.w, reference.sums[i].red.w) << "alpha of pixel " << i;
    }
}

const std::vector<Length> kLengths{{0, kRouletteThroughput}, {1, kRouletteOff},   {2, kRouletteOff},
                                   {8, kRouletteThroughput}, {8, kRouletteFixed}, {40, kRouletteOff}};

TEST(Renderer, OneSampleEqualsReference) {
    expectOneSampleEqualsReference(false, {{1, kRouletteOff}, {40, kRouletteOff}});
    expectOneSampleEqualsReference(true, {{8, kRouletteThroughput}, {8, kRouletteFixed}});
}

TEST(Renderer, FullOneSampleEqualsReferenceAtEveryDepthAndRoulette) {
    for (const bool instances : {false, true}) expectOneSampleEqualsReference(instances, kLengths);
}

TEST(Renderer, DepthZeroIsEmissionAlone) {
    SceneArrays arrays = makeArrays(makeLamps());
    RenderOptions options = makeOptions(32, 24, 2);
    options.params.maxDepth = 0;
    WavefrontStats stats;
    const Film film = renderWith(arrays, options, makeConfig(), &stats);
    EXPECT_EQ(stats.shadowRays, 0U);
    EXPECT_EQ(stats.pathRays, stats.paths);
    int lit = 0, dark = 0;
    for (const FilmSums& s : film.sums) (glm::uvec3(s.red) != glm::uvec3(0) ? lit : dark) += 1;
    EXPECT_GT(lit, 5) << "no lamp is in view";
    EXPECT_GT(dark, 400) << "the floor must not be lit";
}

TEST(Renderer, StopsBetweenPassesWithItsTrueSampleCount) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = makeOptions(24, 20, 40);
    WavefrontConfig config = makeConfig();
    config.pathsInFlight = 24 * 20 * 2;  // two samples in the first pass, 16 in the next
    std::atomic<bool> stop = false;
    std::uint64_t last = 0;
    RenderControl control;
    control.stop = &stop;
    control.progress = [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_EQ(total, 24U * 20 * 40);
        EXPECT_GT(done, last);
        last = done;
        if (done >= 24U * 20 * 4) stop = true;
    };
    const Film stopped = renderWith(arrays, options, config, nullptr, control);
    EXPECT_EQ(stopped.samples(), 18U);
    options.sampleEnd = 18;
    EXPECT_TRUE(isSame(stopped, renderWith(arrays, options)));
    for (const FilmSums& s : stopped.sums) ASSERT_EQ(s.red.w, 18U);
}

TEST(Renderer, APastDeadlineStillGivesOnePass) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = makeOptions(24, 20, 12);
    WavefrontConfig config = makeConfig();
    config.pathsInFlight = 24 * 20;
    RenderControl control;
    control.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    const Film film = renderWith(arrays, options, config, nullptr, control);
    EXPECT_EQ(film.samples(), 1U);
    options.sampleEnd = 1;
    EXPECT_TRUE(isSame(film, renderWith(arrays, options)));
}

TEST(Renderer, AnEmptySceneShowsItsBackground) {
    SceneArrays arrays;
    arrays.meshRanges = {{}};
    buildBvh(arrays);
    RenderOptions options = makeOptions(8, 4, 3);
    options.params.backgroundMode = kBackgroundColor;
    options.params.background = {0.25F, 0.5F, 1};
    const Image image = filmToImage(renderWith(arrays, options));
    for (std::size_t i = 0; i < image.pixels.size(); i += 4)
        ASSERT_EQ(glm::vec4(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2], image.pixels[i + 3]),
                  glm::vec4(0.25F, 0.5F, 1, 1));
    options.params.backgroundMode = kBackgroundTransparent;
    for (const FilmSums& s : renderWith(arrays, options).sums) ASSERT_EQ(s.red, glm::uvec4(0));
}

}  // namespace
}  // namespace vkpt
