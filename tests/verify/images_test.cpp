// The image rungs: what they must accept and what they must reject.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "bvh/build.h"
#include "gltf/import.h"
#include "reference/render.h"
#include "scene/camera.h"
#include "verify/faults.h"
#include "verify/images.h"
#include "verify/ladder.h"
#include "verify/test_context.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kReplicates = 32;

struct Prepared {
    SceneArrays arrays;
    RenderOptions options;
};

/// A bundled scene seen by its own camera, as `vkpt verify` renders it.
Prepared bundled(const std::string& name, std::uint32_t maxDepth) {
    const Scene scene = importGltf(std::filesystem::path(VKPT_SCENES) / name / "scene.gltf", {});
    Prepared p{makeArrays(scene), makeOptions(72, 72, 4)};
    p.options.params.maxDepth = maxDepth;
    fromCamera(p.options.params, scene, scene.cameras.at(0));
    return p;
}

RenderSeed referenceOf(const SceneArrays& arrays, const RenderOptions& options) {
    return [&](std::uint32_t seed) {
        RenderOptions other = options;
        other.params.seed = seed;
        return filmToImage(renderReference(arrays, other));
    };
}

RenderSeed deviceOf(WavefrontRenderer& renderer, const RenderOptions& options) {
    return [&](std::uint32_t seed) {
        renderer.select(seed, options.sampleBegin, options.sampleEnd);
        return filmToImage(renderer.render({}));
    };
}

TEST(Replicates, OfOneRendererAgree) {
    const Prepared p = bundled("cornell_box", 4);
    const RenderSeed render = referenceOf(p.arrays, p.options);
    const ReplicateResult result = compareReplicates(render, render, 1, kReplicates);
    EXPECT_EQ(result.tiles.size(), 9U * 9 * 3);
    EXPECT_EQ(result.whole.size(), 3U);
    EXPECT_NEAR(result.level, 0.01 / 246, 1e-6);
    EXPECT_TRUE(result.agrees()) << result.worst().test.p;
}

TEST(Replicates, RejectAnAlbedoThatIsOffByTwoPercent) {
    const Prepared p = bundled("cornell_box", 4);
    SceneArrays brighter = p.arrays;
    for (MaterialRecord& material : brighter.materials) material.baseColor *= glm::vec4(1.02F, 1.02F, 1.02F, 1);
    WavefrontRenderer renderer(p.arrays, p.options, testConfig(true).wavefront);
    const RenderSeed device = deviceOf(renderer, p.options);
    EXPECT_TRUE(compareReplicates(device, referenceOf(p.arrays, p.options), 1, kReplicates).agrees());
    const auto result = compareReplicates(device, referenceOf(brighter, p.options), 1, kReplicates);
    EXPECT_FALSE(result.agrees()) << "p " << result.worst().test.p << ", level " << result.level;
}

TEST(Replicates, RejectADroppedMisWeight) {
    const Prepared p = bundled("mis_plates", 2);
    FaultyShaders shaders(faultNamed("gpu_mis_light"));
    WavefrontConfig config = testConfig(true).wavefront;
    config.kernels = shaders.kernels();
    WavefrontRenderer renderer(p.arrays, p.options, config);
    const auto result =
        compareReplicates(deviceOf(renderer, p.options), referenceOf(p.arrays, p.options), 1, kReplicates);
    EXPECT_FALSE(result.agrees()) << "p " << result.worst().test.p << ", level " << result.level;
}

TEST(Replicates, AllowForRoundingButNotForNan) {
    const auto constant = [](float value) {
        return [value](std::uint32_t) {
            Image image(10, 9, 4);
            std::ranges::fill(image.pixels, value);
            return image;
        };
    };
    EXPECT_TRUE(compareReplicates(constant(0.5F), constant(0.5F * (1 + 5e-6F)), 0, 4).agrees());
    EXPECT_FALSE(compareReplicates(constant(0.5F), constant(0.5F * (1 + 5e-5F)), 0, 4).agrees());
    EXPECT_FALSE(compareReplicates(constant(0.5F), constant(NAN), 0, 4).agrees());
    EXPECT_TRUE(compareReplicates(constant(0), constant(0), 0, 4).agrees());
    const auto result = compareReplicates(constant(1), constant(1), 0, 4);
    ASSERT_EQ(result.tiles.size(), 4U * 3) << "tiles at the border are smaller";
    EXPECT_EQ(result.tiles.back().width, 2U);
    EXPECT_EQ(result.tiles.back().height, 1U);
}

/// Films of one sample whose pixels are grey.
Film grey(const std::vector<float>& values) {
    Film film;
    film.width = static_cast<std::uint32_t>(values.size());
    film.height = 1;
    film.ranges = {{0, 1}};
    for (const float value : values) {
        const auto words = static_cast<std::uint64_t>(std::llround(double{value} * 0x1p48));
        const uvec4 channel(static_cast<std::uint32_t>(words), static_cast<std::uint32_t>(words >> 32U), 0, 0);
        film.sums.push_back({channel, channel, channel});
    }
    return film;
}

TEST(PathDifferences, CountWhatIsOffByMoreThanAThousandth) {
    PathDifferences d;
    d.add(grey({1, 2, 3, 0}), grey({1.0005F, 2.01F, 3, 0}));
    EXPECT_EQ(d.paths(), 4U);
    EXPECT_EQ(d.parted(), 1U);
    ASSERT_TRUE(d.worst());
    EXPECT_EQ(d.worst()->x, 1U);
    EXPECT_NEAR(d.worst()->size, 0.01, 1e-6);
    EXPECT_NEAR(d.meanDifference(0), -0.0105 / 4, 1e-7);
    EXPECT_NEAR(d.partedSize(), 0.01 / (6.0105 / 4), 1e-5);
}

TEST(PathDifferences, ExcuseWhatPartsInATwinOfTheReferenceToo) {
    PathDifferences d;
    const std::vector<Film> twins = {grey({1.01F, 2, 3, 4}), grey({1, 2, 2.9F, 4})};
    d.add(grey({1.1F, 2.01F, 3.5F, 4}), grey({1, 2, 3, 4}), twins);
    EXPECT_EQ(d.parted(), 3U);
    EXPECT_EQ(d.excused(), 2U);
    ASSERT_TRUE(d.worst());
    EXPECT_EQ(d.worst()->x, 1U) << "an excused path is off by more, but this one tells of a fault";
    PathDifferences none;
    none.add(grey({1.1F, 1}), grey({1, 1}), std::vector<Film>{grey({1.2F, 1})});
    ASSERT_TRUE(none.worst()) << "where all are excused there still is a place to name";
    EXPECT_TRUE(none.worst()->excused);
}

TEST(PathDifferences, AShiftOfTheMeanIsMoreThanThreeStandardErrors) {
    PathDifferences shifted, noisy;
    std::vector<float> a(1000), b(1000), c(1000);
    for (std::size_t i = 0; i < a.size(); ++i) {
        a[i] = 1;
        b[i] = 1.001F + (i % 2 == 0 ? 0.001F : -0.001F);
        c[i] = 1 + (i % 2 == 0 ? 0.1F : -0.1F);
    }
    shifted.add(grey(b), grey(a));
    noisy.add(grey(c), grey(a));
    EXPECT_GT(shifted.meanShare(0), 1);
    EXPECT_LT(noisy.meanShare(0), 1);
}

TEST(Ladder, ADarkSceneIsRefusedByTheImagesNotJudged) {
    Scene scene = makeLamps();
    scene.lights.clear();
    for (Material& material : scene.materials) material.emissive = glm::vec3(0);
    const SceneArrays arrays = makeArrays(scene);
    VerifyContext context(arrays, smallOptions(), testConfig(false));
    Findings findings;
    checkSameSeed(context, findings);
    EXPECT_FALSE(findings.refusal().empty());
    EXPECT_FALSE(findings.disagreement());
}

}  // namespace
}  // namespace vkpt
