// Nothing is cut short: many samples, many triangles, many bounces, films beyond one buffer.
#include "reference/render.h"
#include "verify/inputs/scenes.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

// lavapipe ends the loops of an invocation silently after 65,536 rounds: the alpha count tells whether a path is lost.
TEST(RendererLimits, AThousandSamplesAtOnceAreAllThere) {
    const SceneArrays arrays = makeEverything();
    RenderOptions options = makeOptions(6, 5, 1024);
    const Film film = renderWith(arrays, options);
    for (const FilmSums& sums : film.sums) ASSERT_EQ(sums.red.w, 1024U);
    WavefrontConfig config = makeConfig();
    config.pathsInFlight = 30 * 7;
    EXPECT_TRUE(isSame(film, renderWith(arrays, options, config)));
}

TEST(RendererLimits, DepthsBeyondOneSubmissionTraceEveryBounce) {
    const SceneArrays arrays = makeFurnace();
    for (const std::uint32_t depth : {15U, 16U, 17U, 50U}) {
        RenderOptions options = makeOptions(16, 8, 2);
        options.params.maxDepth = depth;
        options.params.rrMode = kRouletteOff;
        WavefrontStats stats;
        const Film film = renderWith(arrays, options, makeConfig(), &stats);
        ReferenceStats reference;
        const Film expected = renderReference(arrays, options, {}, {}, &reference);
        EXPECT_NEAR(static_cast<double>(stats.pathRays), static_cast<double>(reference.pathRays),
                    0.01 * static_cast<double>(reference.pathRays))
            << depth;
        EXPECT_GT(stats.pathRays, stats.paths * depth / 2) << "paths ended early";
        EXPECT_LE(divergedShare(film, expected), 0.02 + 0.002 * depth);
    }
}

// The alpha of a first hit before nothing tells for every pixel whether the walk through the tree came to its end.
TEST(RendererLimits, AMillionTrianglesAreMetWhereTheReferenceMeetsThem) {
    Scene scene;
    scene.materials.push_back(makeMaterial({0.7F, 0.6F, 0.5F}, 0, 1));
    addObject(scene, makeHeightfield(708));
    PunctualLight sun;
    sun.kind = PunctualKind::Directional;
    sun.worldFromLight = makeTransform({0, 0, 0}, -50, {1, 0.3F, 0}, glm::vec3(1));
    scene.lights.push_back(sun);
    const SceneArrays arrays = makeArrays(scene);
    ASSERT_GT(arrays.triangles.size(), 1000000U);
    RenderOptions options = makeOptions(64, 48, 2);
    options.params.backgroundMode = kBackgroundTransparent;
    options.params.maxDepth = 2;
    WavefrontStats stats;
    const Film film = renderWith(arrays, options, makeConfig(), &stats);
    ReferenceStats referenceStats;
    const Film reference = renderReference(arrays, options, {}, {}, &referenceStats);
    std::uint64_t hits = 0;
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        ASSERT_EQ(film.sums[i].red.w, reference.sums[i].red.w) << "pixel " << i;
        hits += film.sums[i].red.w;
    }
    EXPECT_TRUE(hits > stats.paths / 4 && hits < stats.paths) << "the view must show field and sky";
    const auto within = [](std::uint64_t a, std::uint64_t b) { return 500 * (a > b ? a - b : b - a) <= b; };
    EXPECT_TRUE(within(stats.pathRays, referenceStats.pathRays)) << stats.pathRays << " " << referenceStats.pathRays;
    EXPECT_TRUE(within(stats.shadowRays, referenceStats.shadowRays))
        << stats.shadowRays << " " << referenceStats.shadowRays;
    EXPECT_LE(divergedShare(film, reference), 0.005);
}

// 138 MB of film: more than lavapipe binds at once.
TEST(RendererLimits, AFilmBeyondOneBufferIsRenderedInBands) {
    Scene scene;
    scene.materials.push_back(makeMaterial({0.7F, 0.6F, 0.5F}, 0, 1));
    addObject(scene, makeHeightfield(4));
    const SceneArrays arrays = makeArrays(scene);
    RenderOptions options = makeOptions(2048, 1400, 1);
    options.params.backgroundMode = kBackgroundTransparent;
    options.params.maxDepth = 0;
    options.sampler = SamplerId::Random;
    WavefrontStats stats;
    const Film film = renderWith(arrays, options, makeConfig(), &stats);
    EXPECT_EQ(stats.paths, 2048U * 1400);
    const Film reference = renderReference(arrays, options);
    std::size_t differences = 0, hits = 0;
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        differences += film.sums[i].red.w != reference.sums[i].red.w ? 1 : 0;
        hits += film.sums[i].red.w;
    }
    EXPECT_LE(differences, 5U) << "rays at the outline may differ";
    EXPECT_TRUE(hits > film.sums.size() / 8 && hits < film.sums.size());
}

}  // namespace
}  // namespace vkpt
