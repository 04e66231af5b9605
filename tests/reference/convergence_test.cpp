// All estimators converge to one image: replicates of each against those of the default one.
#include <gtest/gtest.h>

#include <map>

#include "compare/replicates.h"
#include "estimate.h"
#include "gltf/import.h"
#include "scene/camera.h"

namespace vkpt {
namespace {

using namespace test;

constexpr std::uint32_t kReplicates = 32;

struct Case {
    SceneArrays scene;
    RenderOptions options;
};

Case bundled(const std::string& name, std::uint32_t maxDepth) {
    const Scene scene = importGltf(std::filesystem::path(VKPT_SCENES) / name / "scene.gltf", {});
    Case c{flatten(scene), {}};
    buildBvh(c.scene);
    c.options.params.width = 32;
    c.options.params.height = 24;
    fromCamera(c.options.params, scene, scene.cameras.at(0));
    c.options.params.maxDepth = maxDepth;
    return c;
}

/// A room with a glowing ceiling, in it a block of tinted glass, rough or smooth, that stands on the floor.
Case glassRoom(float alpha) {
    SceneBuilder builder;
    builder.roomAround(builder.material(bsdfMaterial("lambert:color=0.7/0.6/0.5")), glm::vec3(0), 1);
    builder.quad(builder.material(emitter(glm::vec3(2))), {-0.8F, 0.99F, -0.8F}, {1.6F, 0, 0}, {0, 0, 1.6F});
    Material glass = bsdfMaterial("dielectric:attenuation_color=0.9/0.5/0.2,attenuation_distance=0.5");
    glass.bsdf->alpha = glm::vec2(alpha);
    const std::uint32_t m = builder.material(glass);
    const glm::vec3 lo(-0.5F, -0.98F, -0.6F), x(0.9F, 0, 0.2F), y(0, 1, 0), z(-0.1F, 0, 0.7F), hi = lo + x + y + z;
    builder.quad(m, lo, z, y).quad(m, lo, x, z).quad(m, lo, y, x);
    builder.quad(m, hi, -y, -z).quad(m, hi, -z, -x).quad(m, hi, -x, -y);
    Case c{builder.build(), viewAlongZ(24, 1, 1, 8, 0.95F)};
    c.options.params.projection = kProjectionPerspective;
    return c;
}

/// A renderer of seeds that makes none twice.
RenderSeed rendererOf(const SceneArrays& scene, const RenderOptions& options) {
    const auto images = std::make_shared<std::map<std::uint32_t, Image>>();
    return [&scene, options, images](std::uint32_t seed) {
        const auto [found, isNew] = images->try_emplace(seed);
        if (isNew) {
            RenderOptions other = options;
            other.params.seed = seed;
            found->second = filmToImage(renderReference(scene, other));
        }
        return found->second;
    };
}

/// One comparison of `estimators` in all; together they raise a false alarm in one of a hundred suites.
void expectSame(const RenderSeed& estimator, const RenderSeed& reference, std::size_t estimators) {
    const ReplicateResult result = compareReplicates(estimator, reference, 1, kReplicates);
    const std::size_t means = result.tiles.size() + result.whole.size();
    const MeanComparison& worst = result.worst();
    EXPECT_GE(worst.test.p, sidakLevel(ReplicateResult::kFamilyLevel, means * estimators))
        << worst.a.mean << " instead of " << worst.b.mean << " from pixel " << worst.x << ',' << worst.y << " on, "
        << worst.width << " wide, channel " << worst.channel;
}

/// Every strategy, Russian roulette and hemisphere against path tracing with MIS. `hemispheres`: how many of them.
void checkEveryEstimator(const Case& c, std::uint32_t spp, std::size_t hemispheres) {
    RenderOptions options = c.options;
    options.params.spp = options.sampleEnd = spp;
    const RenderSeed reference = rendererOf(c.scene, options);
    const std::size_t count = std::size(kEveryStrategy) * std::size(kEveryRoulette) * hemispheres;
    for (const NamedId& strategy : kEveryStrategy)
        for (const NamedId& roulette : kEveryRoulette)
            for (std::size_t h = 0; h < hemispheres; ++h) {
                SCOPED_TRACE(std::string(strategy.name) + ", rr " + roulette.name + ", " + kEveryHemisphere[h].name);
                options.params.strategy = strategy.id;
                options.params.hemisphere = kEveryHemisphere[h].id;
                setRoulette(options.params, roulette.id);
                expectSame(rendererOf(c.scene, options), reference, count);
            }
}

TEST(Convergence, OfEveryEstimatorInTheCornellBoxFull) { checkEveryEstimator(bundled("cornell_box", 4), 16, 3); }

// Directions drawn without regard to plates that nearly mirror hardly ever meet the smallest lamp: what they find is
// too skewed for a test of means.
TEST(Convergence, OfEveryEstimatorAtVeachsPlatesFull) { checkEveryEstimator(bundled("mis_plates", 3), 64, 1); }

TEST(Convergence, OfEveryEstimatorInARoomWithGlassFull) {
    checkEveryEstimator(glassRoom(0), 16, 3);
    checkEveryEstimator(glassRoom(0.3F), 16, 3);
}

// The test's power: light counted twice by a hundredth is seen.
TEST(Convergence, IsDeniedToWhatGainsOnePercentFull) {
    const Case c = glassRoom(0.3F);
    RenderOptions options = c.options;
    options.params.spp = options.sampleEnd = 16;
    const RenderSeed reference = rendererOf(c.scene, options);
    const RenderSeed brighter = [&](std::uint32_t seed) {
        Image image = reference(seed);
        for (float& value : image.pixels) value *= 1.01F;
        return image;
    };
    EXPECT_FALSE(compareReplicates(brighter, reference, 1, kReplicates).agrees());
    EXPECT_TRUE(compareReplicates(reference, reference, 1, kReplicates).agrees());
}

}  // namespace
}  // namespace vkpt
