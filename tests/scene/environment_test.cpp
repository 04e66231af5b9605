#include "scene/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/math.h"
#include "scene/default_light.h"
#include "scene/sampling_table.h"
#include "scene_builder.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

constexpr double kTau = 6.283185307179586;

double cellSolidAngle(const SceneArrays& a, std::uint32_t j) {
    return kTau / a.envWidth * (std::cos(kTau / 2 * j / a.envHeight) - std::cos(kTau / 2 * (j + 1) / a.envHeight));
}

EnvironmentMap noiseMap(std::uint32_t width, std::uint32_t height) {
    EnvironmentMap map{width, height, {}};
    for (std::uint64_t i = 0; i < std::uint64_t{width} * height; ++i) {
        const double bright = golden(i * 17) < 0.02 ? 100 : golden(i * 5) < 0.3 ? 0 : 1;
        map.texels.emplace_back(bright * golden(i), bright * golden(i * 3), bright * golden(i * 7));
    }
    return map;
}

std::vector<EnvironmentMap> maps() {
    EnvironmentMap spark{64, 32, std::vector<glm::vec3>(64 * 32)};
    spark.texels[5 * 64] = glm::vec3(1000);  // at the seam
    return {constantEnvironment({1, 2, 3}), studioEnvironment(), noiseMap(37, 18), noiseMap(3, 1), spark};
}

/// Bilinear look-up as estimator.md defines it, without rotation.
glm::dvec3 lookUp(const SceneArrays& a, double u, double v) {
    const double x = u * a.envWidth - 0.5, y = v * a.envHeight - 0.5;
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    const auto texel = [&](std::int64_t i, std::int64_t j) {
        const std::int64_t w = a.envWidth, h = a.envHeight;
        i = (i % w + w) % w;
        j = std::clamp<std::int64_t>(j, 0, h - 1);
        return glm::dvec3(a.envTexels[static_cast<std::size_t>(j * w + i)]);
    };
    const auto i = static_cast<std::int64_t>(std::floor(x)), j = static_cast<std::int64_t>(std::floor(y));
    return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), fx), glm::mix(texel(i, j + 1), texel(i + 1, j + 1), fx), fy);
}

struct DirectionSample {
    double u, v, pdf;
};

/// Table inversion as estimator.md defines it.
DirectionSample sampleMap(const SceneArrays& a, float u0, float u1) {
    const auto invert = [](const float* cdf, float value, double& fraction) {
        std::size_t i = 0;
        while (!(value < cdf[i])) ++i;
        const double low = i == 0 ? 0 : cdf[i - 1];
        fraction = (value - low) / (cdf[i] - low);
        return i;
    };
    double f = 0, g = 0;
    const std::size_t j = invert(a.envRows.data(), u1, f);
    const std::size_t stride = (a.envWidth + 3) / 4 * 4;
    const std::size_t i = invert(a.envColumns.data() + j * stride, u0, g);
    const double top = std::cos(kTau / 2 * static_cast<double>(j) / a.envHeight);
    const double bottom = std::cos(kTau / 2 * static_cast<double>(j + 1) / a.envHeight);
    return {(static_cast<double>(i) + g) / a.envWidth, std::acos(glm::mix(top, bottom, f)) / (kTau / 2),
            a.envTexels[j * a.envWidth + i].w};
}

TEST(Environment, PdfIntegratesToOne) {
    for (const EnvironmentMap& map : maps()) {
        SceneArrays a;
        addEnvironment(a, map, 1, 0);
        double integral = 0;
        for (std::uint32_t j = 0; j < a.envHeight; ++j) {
            for (std::uint32_t i = 0; i < a.envWidth; ++i) {
                integral += cellSolidAngle(a, j) * a.envTexels[std::size_t{j} * a.envWidth + i].w;
            }
        }
        EXPECT_NEAR(integral, 1, 1e-6) << map.width;
    }
}

TEST(Environment, PdfFollowsTheMeanLuminanceOfTheInterpolatedCell) {
    SceneArrays a;
    addEnvironment(a, noiseMap(24, 12), 1, 0);
    constexpr int kSteps = 16;  // midpoints; even, so that no step straddles the kink at the texel's centre
    std::vector<double> importance;
    double total = 0;
    for (std::uint32_t j = 0; j < a.envHeight; ++j) {
        for (std::uint32_t i = 0; i < a.envWidth; ++i) {
            double sum = 0;
            for (int k = 0; k < kSteps * kSteps; ++k) {
                const double u = (i + (k % kSteps + 0.5) / kSteps) / a.envWidth;
                const double v = (j + (k / kSteps + 0.5) / kSteps) / a.envHeight;
                sum += luminance(glm::vec3(lookUp(a, u, v)));
            }
            importance.push_back(sum / (kSteps * kSteps));
            total += importance.back() * cellSolidAngle(a, j);
        }
    }
    for (std::size_t i = 0; i < importance.size(); ++i) {
        EXPECT_NEAR(a.envTexels[i].w, importance[i] / total, 1e-3 * importance[i] / total + 1e-4) << i;
    }
}

TEST(Environment, TablesAreSortedPaddedAndEndAtOne) {
    for (const EnvironmentMap& map : maps()) {
        SceneArrays a;
        addEnvironment(a, map, 1, 0);
        ASSERT_EQ(a.envRows.size(), (map.height + 3) / 4 * 4);
        ASSERT_EQ(a.envColumns.size(), std::size_t{(map.width + 3) / 4 * 4} * map.height);
        EXPECT_TRUE(std::is_sorted(a.envRows.begin(), a.envRows.end()));
        EXPECT_EQ(a.envRows[map.height - 1], 1.0F);
        EXPECT_EQ(a.envRows.back(), 1.0F);
        for (std::size_t j = 0; j < map.height; ++j) {
            const auto row = a.envColumns.begin() + static_cast<std::ptrdiff_t>(j * ((map.width + 3) / 4 * 4));
            EXPECT_TRUE(std::is_sorted(row, row + (map.width + 3) / 4 * 4));
            EXPECT_EQ(row[map.width - 1], 1.0F);
        }
    }
}

/// Importance sampling with these tables must give the same mean radiance as plain quadrature.
TEST(Environment, SamplingEstimatesTheIntegralOfRadiance) {
    for (const EnvironmentMap& map : maps()) {
        SceneArrays a;
        addEnvironment(a, map, 1, 0);
        constexpr int kCells = 400;
        double sampled = 0;
        for (int k = 0; k < kCells * kCells; ++k) {
            const auto u0 = static_cast<float>((k % kCells + 0.5) / kCells),
                       u1 = static_cast<float>((k / kCells + 0.5) / kCells);
            const DirectionSample s = sampleMap(a, u0, u1);
            ASSERT_GT(s.pdf, 0);
            sampled += luminance(glm::vec3(lookUp(a, s.u, s.v))) / s.pdf / (kCells * kCells);
        }
        double quadrature = 0;
        constexpr int kRows = 1000, kColumns = 2000;
        for (int j = 0; j < kRows; ++j) {
            for (int i = 0; i < kColumns; ++i) {
                const double v = (j + 0.5) / kRows;
                quadrature += luminance(glm::vec3(lookUp(a, (i + 0.5) / kColumns, v))) * std::sin(kTau / 2 * v);
            }
        }
        quadrature *= kTau * (kTau / 2) / kRows / kColumns;
        EXPECT_NEAR(sampled / quadrature, 1, 0.01) << map.width << "x" << map.height;
    }
}

TEST(Environment, ConstantMapHasTheUniformPdf) {
    SceneArrays a;
    addEnvironment(a, constantEnvironment(glm::vec3(0.5F)), 3, 90);
    ASSERT_EQ(a.envTexels.size(), 1U);
    EXPECT_FLOAT_EQ(a.envTexels[0].w, static_cast<float>(1 / (2 * kTau)));
    EXPECT_EQ(a.envTexels[0].x, 1.5F);
    EXPECT_FLOAT_EQ(a.envRotation, kPi / 2);
    EXPECT_TRUE(a.features.environment);
}

TEST(Environment, BlackMapsGiveNoLight) {
    SceneArrays a = flatten(sceneOf(trianglePrimitive()));
    addEnvironment(a, studioEnvironment(), 1, 0);
    EXPECT_EQ(a.lights.size(), 1U);
    addEnvironment(a, {4, 2, std::vector<glm::vec3>(8)}, 1, 0);
    EXPECT_TRUE(a.lights.empty());
    EXPECT_TRUE(a.envTexels.empty());
    EXPECT_FALSE(a.features.environment);
    EXPECT_EQ(a.envLight, kNone);
    addEnvironment(a, studioEnvironment(), 0, 0);
    EXPECT_TRUE(a.lights.empty());
}

TEST(Environment, ReplacesTheOneBeforeAndKeepsOtherLights) {
    Scene scene = sceneOf(trianglePrimitive());
    scene.lights.push_back({});
    SceneArrays a = flatten(scene);
    addEnvironment(a, constantEnvironment(glm::vec3(1)), 1, 0);
    addEnvironment(a, constantEnvironment(glm::vec3(2)), 1, 0);
    ASSERT_EQ(a.lights.size(), 2U);
    EXPECT_EQ(a.envLight, 1U);
    EXPECT_EQ(a.lights[1].kind, kLightEnvironment);
    EXPECT_EQ(a.lightCdf.back(), 1.0F);
}

TEST(Environment, BrightestFloatsStayFinite) {
    SceneArrays a;
    addEnvironment(a, constantEnvironment(glm::vec3(3e38F)), 1e10F, 0);
    EXPECT_TRUE(std::isfinite(a.envTexels[0].x));
    EXPECT_FLOAT_EQ(a.envTexels[0].w, static_cast<float>(1 / (2 * kTau)));
}

TEST(Studio, HasTheMeanItPromisesAndNoBlackSpot) {
    const EnvironmentMap map = studioEnvironment();
    double mean = 0, least = 1e9, most = 0;
    for (std::uint32_t j = 0; j < map.height; ++j) {
        const double top = std::cos(kTau / 2 * j / map.height), bottom = std::cos(kTau / 2 * (j + 1) / map.height);
        for (std::uint32_t i = 0; i < map.width; ++i) {
            const double l = luminance(map.texels[std::size_t{j} * map.width + i]);
            mean += l * (top - bottom) / 2 / map.width;
            least = std::min(least, l);
            most = std::max(most, l);
        }
    }
    EXPECT_NEAR(mean, kStudioMean, 0.01);
    EXPECT_GT(least, 0.02);
    EXPECT_GT(most, 5);
}

TEST(Studio, LightsFromTheUpperLeftOfACameraAtPlusZ) {
    const EnvironmentMap map = studioEnvironment();
    glm::dvec3 mean(0);
    for (std::uint32_t j = 0; j < map.height; ++j) {
        const double theta = kTau / 2 * (j + 0.5) / map.height;
        for (std::uint32_t i = 0; i < map.width; ++i) {
            const double phi = kTau * ((i + 0.5) / map.width - 0.5);
            const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            mean += d * std::sin(theta) * double{luminance(map.texels[std::size_t{j} * map.width + i])};
        }
    }
    EXPECT_LT(mean.x, 0);
    EXPECT_GT(mean.y, 0);
    EXPECT_GT(mean.z, 0);
}

TEST(ReadEnvironment, ReadsEveryBundledMap) {
    const std::filesystem::path folder = std::filesystem::path(VKPT_ASSETS) / "env";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "absent: " << folder;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".hdr" && entry.path().extension() != ".exr") continue;
        const EnvironmentMap map = readEnvironment(entry.path());
        ASSERT_EQ(map.texels.size(), std::size_t{map.width} * map.height) << entry.path();
        EXPECT_TRUE(std::all_of(map.texels.begin(), map.texels.end(), [](const glm::vec3& t) {
            return isFinite(t) && t.x >= 0 && t.y >= 0 && t.z >= 0;
        })) << entry.path();
    }
}

TEST(ReadEnvironment, ReplacesNonFiniteAndNegativeValuesByZero) {
    const float values[] = {NAN, INFINITY, -1, 0.5F, 2, 3};
    const TemporaryFolder folder;
    const EnvironmentMap map = readEnvironment(
        folder.write("a.pfm", "PF\n2 1\n-1\n" + std::string(reinterpret_cast<const char*>(values), sizeof values)));
    EXPECT_EQ(map.texels, (std::vector<glm::vec3>{{0, 0, 0}, {0.5F, 2, 3}}));
}

TEST(DefaultLight, OnlyEvenEmissionAndPunctualLightsLightAScene) {
    Scene scene = sceneOf(trianglePrimitive());
    EXPECT_FALSE(hasOwnLight(flatten(scene)));
    scene.materials[0].emissive = glm::vec3(1);
    EXPECT_TRUE(hasOwnLight(flatten(scene)));
    scene.images.push_back(imageOf(2, 2, 0xffffffffU));
    scene.materials[0].emissiveTexture.image = 0;
    EXPECT_FALSE(hasOwnLight(flatten(scene)));
    scene.lights.push_back({});
    EXPECT_TRUE(hasOwnLight(flatten(scene)));
}

}  // namespace
}  // namespace vkpt
