// Lights: geometry, falloffs, and samples that follow their densities.
#include "reference/light.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "reference/hash.h"
#include "reference/lights/punctual.h"
#include "statistics.h"
#include "test_scene.h"

namespace vkpt::reference {
namespace {

using test::SceneBuilder;

Vec2<float> randomSquare(std::uint32_t i) {
    const glm::uvec4 h = hash({i, 0, 0, 43});
    return {toUnit(h.x), toUnit(h.y)};
}

glm::uvec2 randomBits(std::uint32_t i, std::uint32_t stream) {
    const glm::uvec4 h = hash({i, stream, 2, 2});
    return {h.x, h.y};
}

TEST(SampleTable, TakesTheFirstIntervalThatHoldsU) {
    const float cdf[] = {0.25F, 0.25F, 0.75F, 1.0F};
    EXPECT_EQ(sampleTable(cdf, 0.0F).index, 0U);
    EXPECT_EQ(sampleTable(cdf, 0.25F).index, 2U);  // index 1 has no share
    EXPECT_FLOAT_EQ(sampleTable(cdf, 0.5F).fraction, 0.5F);
    EXPECT_EQ(sampleTable(cdf, 0.99F).index, 3U);
    const float shortOfOne[] = {0.5F, 0.9F};
    EXPECT_EQ(sampleTable(shortOfOne, 0.95F).index, 1U);
}

TEST(Environment, FollowsTheConvention) {
    const auto uv = [](double x, double y, double z) { return environmentUv(Vec3<double>(x, y, z)); };
    EXPECT_NEAR(uv(0, 0, -1).x, 0.25, 1e-12);
    EXPECT_NEAR(uv(1, 0, 0).x, 0.5, 1e-12);
    EXPECT_NEAR(uv(0, 0, 1).x, 0.75, 1e-12);
    EXPECT_NEAR(uv(0, 1, 0).y, 0, 1e-12);
    EXPECT_NEAR(uv(0, -1, 0).y, 1, 1e-12);
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Vec2<double> u(randomSquare(i));
        const Vec2<double> back = environmentUv(environmentDirection(u.x, std::cos(kPiOf<double> * u.y)));
        EXPECT_NEAR(glm::distance(back, u), 0, 1e-9);
    }
}

/// 16 x 8 texels of strongly varying radiance, one row and some cells black.
EnvironmentMap patchyMap() {
    EnvironmentMap map{16, 8, {}};
    for (std::uint32_t i = 0; i < 128; ++i) {
        const float x = toUnit(hash({i, 1, 2, 9}).x);
        map.texels.emplace_back(i / 16 == 5 || i % 7 == 0 ? glm::vec3(0) : glm::vec3(20 * x * x * x * x, x, 0.5F));
    }
    return map;
}

// pdf(d) is a density: it integrates to 1, equals the one the sample carries, and samples fall where it says.
TEST(Environment, SamplesFollowTheDensity) {
    const EnvironmentMap map = patchyMap();
    SceneArrays scene;
    addEnvironment(scene, map, 1, 37);
    const Environment environment(scene);
    constexpr std::size_t kRows = 40, kColumns = 48;  // not multiples of the map's
    constexpr std::uint32_t kDraws = 200000;
    constexpr int kSub = 12;
    std::vector<double> counts(kRows * kColumns), expected(kRows * kColumns);
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const auto s = environment.sample(randomSquare(i));
        ASSERT_NEAR(glm::length(s.direction), 1, 1e-6);
        const double turns = std::atan2(double{s.direction.z}, double{s.direction.x}) / (2 * kPiOf<double>)+0.5;
        const auto row = std::min(kRows - 1, static_cast<std::size_t>((double{s.direction.y} + 1) / 2 * kRows));
        counts[row * kColumns + static_cast<std::size_t>(turns * kColumns) % kColumns] += 1;
    }
    double integral = 0;
    for (std::size_t cell = 0; cell < expected.size(); ++cell) {
        for (int i = 0; i < kSub * kSub; ++i) {
            const double y = 2 * (static_cast<double>(cell / kColumns) + (i / kSub + 0.5) / kSub) / kRows - 1;
            const double u = (static_cast<double>(cell % kColumns) + (i % kSub + 0.5) / kSub) / kColumns;
            const double share = double{environment.pdf(glm::vec3(environmentDirection(u, y)))} * 4 * kPiOf<double> /
                                 (kRows * kColumns * kSub * kSub);
            expected[cell] += kDraws * share;
            integral += share;
        }
    }
    EXPECT_NEAR(integral, 1, 0.01);
    // The grid above integrates cells that it cuts only to about a percent; scale to compare shapes.
    EXPECT_LT(test::chiSquareDeviate(counts, expected), 8);
}

TEST(Environment, SampleCarriesTheDensityOfItsDirection) {
    SceneArrays scene;
    addEnvironment(scene, patchyMap(), 2, 200);
    const Environment environment(scene);
    std::uint32_t differing = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const auto s = environment.sample(randomSquare(i));
        EXPECT_GT(s.pdf, 0);
        differing += std::abs(environment.pdf(s.direction) - s.pdf) > 1e-5F * s.pdf ? 1 : 0;
    }
    EXPECT_LT(differing, 5U);  // directions that round across a cell's border
}

// The estimator of the whole sphere's light has the map's own integral as its mean.
TEST(Environment, SampledIntegralEqualsTheMaps) {
    EnvironmentMap map{64, 32, {}};
    double truth = 0;
    for (std::uint32_t j = 0; j < 32; ++j) {
        for (std::uint32_t i = 0; i < 64; ++i) {
            const float x = 1 + std::sin(static_cast<float>(i) * kPi / 32) * std::sin(static_cast<float>(j) * kPi / 32);
            map.texels.emplace_back(x, 2 * x, 0.1F);
        }
    }
    SceneArrays scene;
    addEnvironment(scene, map, 1, 90);
    const Environment environment(scene);
    constexpr int kGrid = 512;
    for (int j = 0; j < kGrid; ++j) {
        for (int i = 0; i < 2 * kGrid; ++i) {
            const double y = 2 * (j + 0.5) / kGrid - 1;
            truth += double{environment.radiance(glm::vec3(environmentDirection((i + 0.5) / (2 * kGrid), y))).x} * 4 *
                     kPiOf<double> / (2.0 * kGrid * kGrid);
        }
    }
    double mean = 0;
    constexpr std::uint32_t kDraws = 100000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const auto s = environment.sample(randomSquare(i));
        mean += double{environment.radiance(s.direction).x / s.pdf} / kDraws;
    }
    EXPECT_NEAR(mean / truth, 1, 0.005);
}

TEST(Environment, RadianceIsBilinearWrapsAndTurns) {
    EnvironmentMap map{4, 2, {}};
    for (std::uint32_t i = 0; i < 8; ++i) map.texels.emplace_back(glm::vec3(static_cast<float>(i)));
    SceneArrays scene;
    addEnvironment(scene, map, 1, 0);
    const auto at = [&scene](double u, double v) {
        return Environment(scene).radiance(glm::vec3(environmentDirection(u, std::cos(kPiOf<double> * v)))).x;
    };
    EXPECT_NEAR(at(0.375, 0.25), 1, 1e-5);
    EXPECT_NEAR(at(0.5, 0.25), 1.5, 1e-5);
    EXPECT_NEAR(at(0.375, 0.5), 3, 1e-5);
    EXPECT_NEAR(at(1.0 / 16, 0.25), 0.75, 1e-5);  // between columns 3 and 0
    EXPECT_NEAR(at(0.375, 0.05), 1, 1e-5);        // clamped at the pole
    addEnvironment(scene, map, 3, 90);            // d' = (c x - s z, y, s x + c z): +x looks up +z
    EXPECT_NEAR(Environment(scene).radiance({1, 0, 0}).x, 3 * 4.5, 1e-3);
}

TEST(Punctual, WindowAndConesFollowTheExtension) {
    EXPECT_EQ(rangeWindow(100.0, 0.0), 1);
    EXPECT_EQ(rangeWindow(100.0, 10.0), 0);
    EXPECT_EQ(rangeWindow(400.0, 10.0), 0);
    EXPECT_NEAR(rangeWindow(25.0, 10.0), 1 - 1.0 / 16, 1e-12);
    const double outer = std::cos(0.6), inner = std::cos(0.3), scale = 1 / (inner - outer), offset = -outer * scale;
    EXPECT_NEAR(spotFalloff(inner, scale, offset), 1, 1e-12);
    EXPECT_NEAR(spotFalloff(outer, scale, offset), 0, 1e-12);
    EXPECT_NEAR(spotFalloff((inner + outer) / 2, scale, offset), 0.25, 1e-12);
    EXPECT_EQ(spotFalloff(1.0, scale, offset), 1);
    EXPECT_EQ(spotFalloff(0.0, scale, offset), 0);
}

TEST(Lights, ChoosesByPowerAndTellsTheProbability) {
    SceneBuilder builder;
    builder.material(test::emitter(glm::vec3(1)));
    builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).quad(0, {-1, -1, -3}, {6, 0, 0}, {0, 6, 0});
    const SceneArrays scene = builder.build();
    ASSERT_EQ(scene.lights.size(), 4U);
    const Lights lights(scene);
    double near = 0;
    constexpr std::uint32_t kDraws = 20000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const auto s = lights.sample({0, 0, 2}, randomBits(i, 2));
        ASSERT_TRUE(s);
        near += s->end.z > -1 ? 1 : 0;
    }
    EXPECT_NEAR(near / kDraws, 0.1, 4 * std::sqrt(0.09 / kDraws));  // areas 4 and 36
}

// The number that chooses is used again, all its 32 bits: the point fills each light, however small its share.
TEST(Lights, OnePairOfNumbersPlacesPointsAllOverEveryLight) {
    SceneBuilder builder;
    builder.material(test::emitter(glm::vec3(1)));
    builder.quad(0, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}).quad(0, {0, 0, 0}, {1e-4F, 0, 0}, {0, 1e-4F, 0});
    const SceneArrays scene = builder.build();
    const Lights lights(scene);
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double begin = i == 0 ? 0 : double{scene.lightCdf[i - 1]}, share = double{scene.lightCdf[i]} - begin;
        std::set<std::pair<int, int>> cells;
        for (int k = 0; k < 64; ++k) {  // of the barycentric (b0, b1): steps of 1/16 along the light's share
            const auto bits = static_cast<std::uint32_t>((begin + share * (k % 16 + 0.5) / 16) * 0x1p32);
            const auto s = lights.sample({0, 0, 2}, {bits, static_cast<std::uint32_t>(k / 16) << 30U | 1U << 29U});
            ASSERT_TRUE(s);
            const LightRecord& light = scene.lights[i];
            const glm::vec3 e = (s->end - light.a) / glm::distance(light.a, light.b);
            cells.insert({static_cast<int>(std::lround(e.x * 64)), static_cast<int>(std::lround(e.y * 64))});
        }
        EXPECT_EQ(cells.size(), 64U) << "light " << i;
    }
}

// 1/pdf is the inverse of a density in solid angle: its mean is the solid angle of the light.
TEST(Lights, TriangleDensityMeasuresSolidAngle) {
    SceneBuilder builder;
    builder.material(test::emitter(glm::vec3(2)));
    builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    const SceneArrays scene = builder.build();
    const Lights lights(scene);
    // Half-sides 1 and 1 at distance 1: 4 asin(1/2).
    const double truth = 4 * std::asin(0.5);
    double mean = 0;
    constexpr std::uint32_t kDraws = 50000;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const auto s = lights.sample({0, 0, 1}, randomBits(i, 3));
        ASSERT_TRUE(s);
        EXPECT_EQ(s->radiance, glm::vec3(2));
        mean += 1 / double{s->pdf} / kDraws;
        // Each triangle is half of the square and chosen half of the time.
        EXPECT_NEAR(lights.pdfTriangle(scene.lights[s->light], {0, 0, 1}), 1 / truth, 1e-6);
        EXPECT_GT(s->end.z, 0) << "the end is offset to the receiver's side";
    }
    EXPECT_NEAR(mean, truth, 0.01);
    EXPECT_FALSE(lights.sample({0, 0, -1}, {0x50000000U, 0x50000000U})) << "behind a one-sided light";
}

TEST(Lights, TwoSidedLightsShineBack) {
    SceneBuilder builder;
    Material m = test::emitter(glm::vec3(2));
    m.doubleSided = true;
    builder.material(m);
    const SceneArrays scene = builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).build();
    const auto s = Lights(scene).sample({0, 0, -1}, {0x50000000U, 0x50000000U});
    ASSERT_TRUE(s);
    EXPECT_LT(s->end.z, 0);
    EXPECT_GT(s->pdf, 0);
}

TEST(Lights, PunctualLightsGiveTheirIrradiance) {
    SceneBuilder builder;
    builder.material(test::matte(glm::vec3(1)));
    PunctualLight point;
    point.intensity = {8, 4, 2};
    point.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(0, 0, 2));
    builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).light(point);
    const SceneArrays scene = builder.build();
    const auto s = Lights(scene).sample({0, 0, 0}, {0x80000000U, 0});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->punctual);
    EXPECT_EQ(s->radiance / s->pdf, glm::vec3(2, 1, 0.5F));
    EXPECT_EQ(s->wi, glm::vec3(0, 0, 1));
    EXPECT_EQ(s->end, glm::vec3(0, 0, 2));
}

}  // namespace
}  // namespace vkpt::reference
