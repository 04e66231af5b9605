// The reference's film is exact and its passes obey RenderControl.
#include <gtest/gtest.h>

#include <cstring>

#include "base/error.h"
#include "test_scene.h"

namespace vkpt {
namespace {

using namespace test;

/// A room with everything in it that paths can meet: metal, matte, lamp, environment.
SceneArrays room() {
    SceneBuilder builder;
    const std::uint32_t white = builder.material(matte(glm::vec3(0.8F)));
    builder.quad(white, {-3, -1, -3}, {0, 0, 6}, {6, 0, 0});
    builder.quad(builder.material(metal({0.9F, 0.7F, 0.4F}, 0.3F)), {-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
    builder.quad(builder.material(emitter({5, 4, 3})), {-1, 2, -1}, {1, 0, 0}, {0, 0, 1});
    return builder.build(glm::vec3(0.3F));
}

RenderOptions rangeOf(std::uint32_t begin, std::uint32_t end, SamplerId sampler) {
    RenderOptions options = viewAlongZ(24, 2, 16, 5);
    options.params.rrMode = kRouletteThroughput;
    options.params.rrDepth = 2;
    options.sampler = sampler;
    options.sampleBegin = begin;
    options.sampleEnd = end;
    return options;
}

void expectSameSums(const Film& a, const Film& b) {
    ASSERT_EQ(a.sums.size(), b.sums.size());
    EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(FilmSums)), 0);
    EXPECT_EQ(a.ranges, b.ranges);
    EXPECT_EQ(a.refused, b.refused);
}

class FilmOf : public testing::TestWithParam<SamplerInfo> {};

TEST_P(FilmOf, TwoRangesAddUpToOneBitForBit) {
    const SceneArrays scene = room();
    Film sum = renderReference(scene, rangeOf(0, 8, GetParam().id));
    addFilm(sum, renderReference(scene, rangeOf(8, 16, GetParam().id)));
    const Film whole = renderReference(scene, rangeOf(0, 16, GetParam().id));
    expectSameSums(sum, whole);
    EXPECT_EQ(whole.refused, 0U);
    EXPECT_GT(meanOf(whole).g, 0.1);
}

TEST_P(FilmOf, ThreadsChangeNothing) {
    const SceneArrays scene = room();
    const RenderOptions options = rangeOf(0, 8, GetParam().id);
    const Film one = renderReference(scene, options, {}, {.threads = 1});
    expectSameSums(one, renderReference(scene, options, {}, {.threads = 3}));
    expectSameSums(one, renderReference(scene, options));
}

TEST_P(FilmOf, SeedsChangeTheNoise) {
    const SceneArrays scene = room();
    RenderOptions options = rangeOf(0, 4, GetParam().id);
    const Film a = renderReference(scene, options);
    options.params.seed = 1;
    const Film b = renderReference(scene, options);
    EXPECT_NE(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(FilmSums)), 0);
    EXPECT_NEAR(meanOf(a).g, meanOf(b).g, 0.1 * meanOf(a).g);
}

INSTANTIATE_TEST_SUITE_P(Registry, FilmOf, testing::ValuesIn(kSamplers),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Large enough for a pass to hold few samples.
RenderOptions manyPasses() {
    RenderOptions options = viewAlongZ(256, 2, 20, 1);
    options.params.backgroundMode = kBackgroundColor;
    return options;
}

TEST(RenderControl, ProgressGrowsToTheTotal) {
    const SceneArrays scene = SceneBuilder().build();
    std::vector<std::uint64_t> done;
    RenderControl control;
    control.progress = [&](std::uint64_t paths, std::uint64_t total) {
        EXPECT_EQ(total, 256U * 256 * 20);
        done.push_back(paths);
    };
    ReferenceStats stats;
    const Film film = renderReference(scene, manyPasses(), control, {}, &stats);
    EXPECT_GT(done.size(), 2U);
    EXPECT_EQ(stats.passes, done.size());
    EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
    EXPECT_EQ(done.back(), 256U * 256 * 20);
    EXPECT_EQ(stats.paths, done.back());
    EXPECT_EQ(stats.pathRays, stats.paths);
    EXPECT_EQ(film.sampleEnd(), 20U);
}

TEST(RenderControl, StopEndsAfterThePassAndTheFilmSaysSo) {
    const SceneArrays scene = SceneBuilder().build();
    std::atomic<bool> stop = false;
    int passes = 0;
    RenderControl control;
    control.stop = &stop;
    control.progress = [&](std::uint64_t, std::uint64_t) { stop = ++passes == 2; };
    const Film film = renderReference(scene, manyPasses(), control);
    EXPECT_EQ(passes, 2);
    EXPECT_GT(film.samples(), 0U);
    EXPECT_LT(film.sampleEnd(), 20U);
    for (const FilmSums& sums : film.sums) ASSERT_EQ(sums.red.w, film.samples());  // alpha of a visible background
}

TEST(RenderControl, APassedDeadlineStillGivesOnePass) {
    const SceneArrays scene = SceneBuilder().build();
    RenderControl control;
    control.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    ReferenceStats stats;
    const Film film = renderReference(scene, manyPasses(), control, {}, &stats);
    EXPECT_EQ(stats.passes, 1U);
    EXPECT_GT(film.samples(), 0U);
    EXPECT_LT(film.sampleEnd(), 20U);
}

// Emission beyond the film's range: refused and counted, while alpha still says that something is there.
TEST(Film, RefusesAndCountsWhatIsNotARadiance) {
    SceneBuilder builder;
    builder.quad(builder.material(emitter(glm::vec3(3e38F))), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    const Film film = renderReference(builder.build(), viewAlongZ(4, 1, 3, 0));
    EXPECT_EQ(film.refused, 4U * 4 * 3);
    EXPECT_EQ(meanOf(film), glm::dvec4(0, 0, 0, 1));
}

TEST(Film, RefusesAnEmptyFrameOrRange) {
    const SceneArrays scene = SceneBuilder().build();
    RenderOptions options = viewAlongZ(4, 1, 3, 0);
    options.sampleBegin = 3;
    EXPECT_THROW((void)renderReference(scene, options), Error);
    options = viewAlongZ(4, 1, 3, 0);
    options.params.width = 0;
    EXPECT_THROW((void)renderReference(scene, options), Error);
}

}  // namespace
}  // namespace vkpt
