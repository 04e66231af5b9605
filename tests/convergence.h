// One image, whatever estimates it: scenes, estimators and how their replicates are judged, for tests of the reference
// and of the device.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>

#include "compare/replicates.h"
#include "gltf/import.h"
#include "reference/estimate.h"
#include "scene/camera.h"

namespace vkpt::test {

struct ConvergenceCase {
    SceneArrays scene;
    RenderOptions options;
};

/// A bundled scene seen by its own camera.
inline ConvergenceCase bundledCase(const char* name, std::uint32_t maxDepth, std::uint32_t spp, glm::uvec2 size) {
    const Scene scene = importGltf(std::filesystem::path(VKPT_SCENES) / name / "scene.gltf", {});
    ConvergenceCase c{flatten(scene), {}};
    buildBvh(c.scene);
    RenderParams& p = c.options.params;
    p.width = size.x;
    p.height = size.y;
    fromCamera(p, scene, scene.cameras.at(0));
    p.maxDepth = maxDepth;
    p.spp = c.options.sampleEnd = spp;
    return c;
}

inline ConvergenceCase cornellBox() { return bundledCase("cornell_box", 4, 16, {32, 24}); }
inline ConvergenceCase smallCornellBox() { return bundledCase("cornell_box", 3, 4, {16, 12}); }
/// Many samples: few of those of a lamp meet the narrow lobes of its plates.
inline ConvergenceCase veachsPlates() { return bundledCase("mis_plates", 3, 256, {16, 12}); }
/// The same of a roughness of 0.5.
inline ConvergenceCase dullPlates() {
    ConvergenceCase c = veachsPlates();
    for (MaterialRecord& material : c.scene.materials) material.roughness = std::max(material.roughness, 0.5F);
    return c;
}

/// A block of tinted glass that stands on the floor of a room from -1 to 1.
inline void addGlassBlock(SceneBuilder& builder, float alpha, float left) {
    Material glass = bsdfMaterial("dielectric:attenuation_color=0.9/0.5/0.2,attenuation_distance=0.5");
    glass.bsdf->alpha = glm::vec2(alpha);
    const std::uint32_t m = builder.material(glass);
    const glm::vec3 lo(left, -0.98F, -0.6F), x(0.6F, 0, 0.15F), y(0, 1, 0), z(-0.1F, 0, 0.7F), hi = lo + x + y + z;
    builder.quad(m, lo, z, y).quad(m, lo, x, z).quad(m, lo, y, x);
    builder.quad(m, hi, -y, -z).quad(m, hi, -z, -x).quad(m, hi, -x, -y);
}

/// A room with a glowing ceiling, in it a block of smooth and one of rough glass.
inline ConvergenceCase glassRoom() {
    SceneBuilder builder;
    builder.roomAround(builder.material(bsdfMaterial("lambert:color=0.7/0.6/0.5")), glm::vec3(0), 1);
    builder.quad(builder.material(emitter(glm::vec3(2))), {-0.8F, 0.99F, -0.8F}, {1.6F, 0, 0}, {0, 0, 1.6F});
    addGlassBlock(builder, 0, -0.7F);
    addGlassBlock(builder, 0.3F, 0.2F);
    ConvergenceCase c{builder.build(), viewAlongZ(16, 1, 16, 8, 0.95F)};
    c.options.params.projection = kProjectionPerspective;
    return c;
}

struct Estimator {
    SamplerChoice sampler;
    NamedId strategy = kEveryStrategy[0], hemisphere = kEveryHemisphere[0], roulette = kEveryRoulette[0];
};

inline std::string describe(const Estimator& e) {
    return std::string(samplerName(e.sampler.id)) + ' ' + std::string(scrambleName(e.sampler.scramble)) + ", " +
           e.strategy.name + ", hemisphere " + e.hemisphere.name + ", rr " + e.roulette.name;
}

/// Directions are drawn without regard to the BSDF, and lamps met by chance alone. Plates that nearly mirror hardly
/// ever show a small lamp then: what is found is right, but too skewed for a test of means.
inline bool isBlind(const Estimator& e) { return e.strategy.id == kStrategyBsdf && e.hemisphere.id != kHemisphereBsdf; }

struct ConvergenceScene {
    const char* name;
    ConvergenceCase (*make)();
    bool (*suits)(const Estimator&) = [](const Estimator&) { return true; };
};
inline void PrintTo(const ConvergenceScene& scene, std::ostream* out) { *out << scene.name; }  // found by GoogleTest
inline constexpr std::array kConvergenceScenes = {
    ConvergenceScene{"cornell_box", cornellBox},
    ConvergenceScene{"mis_plates", veachsPlates, [](const Estimator& e) { return !isBlind(e); }},
    ConvergenceScene{"dull_plates", dullPlates, isBlind}, ConvergenceScene{"glass", glassRoom}};

/// Sobol's points under every strategy, hemisphere and Russian roulette, and mis-power with every sampler whose points
/// depend on the seed.
inline std::vector<Estimator> estimatorsIn(const ConvergenceScene& scene) {
    std::vector<Estimator> estimators;
    for (const NamedId& strategy : kEveryStrategy)
        for (const NamedId& hemisphere : kEveryHemisphere)
            for (const NamedId& roulette : kEveryRoulette)  // innermost: the device's kernels are the same for all
                estimators.push_back({{}, strategy, hemisphere, roulette});
    for (const SamplerChoice& sampler : allSamplerChoices())
        if (sampler.isRandomised()) estimators.push_back({.sampler = sampler});
    std::erase_if(estimators, [&](const Estimator& e) { return !scene.suits(e); });
    return estimators;
}

/// A few of them all, for the quick tests.
inline std::vector<Estimator> someEstimators() {
    const auto& s = kEveryStrategy;
    const auto& h = kEveryHemisphere;
    const auto& r = kEveryRoulette;
    return {{SamplerId::Orthogonal, s[0], h[0], r[1]},
            {SamplerId::Halton, s[1], h[1], r[2]},
            {SamplerId::Zsobol, s[2], h[2], r[0]},
            {SamplerId::Random, s[3], h[0], r[2]}};
}

inline constexpr std::uint32_t kReplicatesASide = 32;

/// One of `estimators` comparisons: together they raise a false alarm in one of a hundred tests.
inline ReplicateResult compareToReference(const RenderSeed& estimator, const RenderSeed& reference,
                                          std::size_t estimators) {
    ReplicateResult result = compareReplicates(estimator, reference, 1, kReplicatesASide);
    const std::size_t means = result.tiles.size() + result.whole.size();
    result.level = sidakLevel(ReplicateResult::kFamilyLevel, means * estimators);
    return result;
}

inline RenderSeed imagesOf(FilmOfSeed render) {
    return [render = std::move(render)](std::uint32_t seed) { return filmToImage(render(seed)); };
}

/// The one image that all are compared with: path tracing by the reference with MIS and Sobol's points, roulette off.
/// Renders no seed twice; the case must outlive it.
inline RenderSeed referenceOf(const ConvergenceCase& c) {
    return [render = imagesOf(onReference(c.scene, c.options)),
            images = std::make_shared<std::map<std::uint32_t, Image>>()](std::uint32_t seed) {
        const auto [found, isNew] = images->try_emplace(seed);
        if (isNew) found->second = render(seed);
        return found->second;
    };
}

inline RenderOptions optionsOf(const ConvergenceCase& c, const Estimator& e) {
    RenderOptions options = c.options;
    options.sampler = e.sampler;
    options.params.spp = options.sampleEnd = sampleCount(e.sampler.id, options.params.spp);
    options.params.strategy = e.strategy.id;
    options.params.hemisphere = e.hemisphere.id;
    setRoulette(options.params, e.roulette.id);
    return options;
}

/// Each estimator on `renderer` gives the image of the case.
inline void expectOneImage(const ConvergenceCase& c, const std::vector<Estimator>& estimators,
                           const Renderer& renderer) {
    const RenderSeed reference = referenceOf(c);
    for (const Estimator& estimator : estimators) {
        const auto result =
            compareToReference(imagesOf(renderer(c.scene, optionsOf(c, estimator))), reference, estimators.size());
        const MeanComparison& worst = result.worst();
        EXPECT_TRUE(result.agrees()) << describe(estimator) << ": " << worst.a.mean << " instead of " << worst.b.mean
                                     << " from pixel " << worst.x << ',' << worst.y << " on, " << worst.width
                                     << " wide, channel " << worst.channel << ", p " << worst.test.p << ", level "
                                     << result.level;
    }
}

}  // namespace vkpt::test
