// A mean of renders with its standard error. Whole renders of other seeds are the replicates: samples of one seed are
// not independent of each other.
#pragma once
#include <array>
#include <functional>

#include "compare/statistics.h"
#include "test_scene.h"

namespace vkpt::test {

struct Estimate {
    double mean = 0, standardError = 0;
};

/// The film of each seed, of one scene under one set of options.
using FilmOfSeed = std::function<Film(std::uint32_t seed)>;
/// Makes one; the scene must outlive it. Tests that take a Renderer run on the reference and on the device.
using Renderer = std::function<FilmOfSeed(const SceneArrays& scene, const RenderOptions& options)>;

inline FilmOfSeed onReference(const SceneArrays& scene, const RenderOptions& options) {
    return [&scene, options](std::uint32_t seed) {
        RenderOptions other = options;
        other.params.seed = seed;
        return renderReference(scene, other);
    };
}

/// Of the mean of the image over `seeds` renders, a channel each.
inline std::array<Estimate, 3> estimateRgb(const FilmOfSeed& render, std::uint32_t seeds) {
    std::array<std::vector<double>, 3> means;
    for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
        const glm::dvec4 mean = meanOf(render(seed));
        for (std::size_t c = 0; c < 3; ++c) means[c].push_back(mean[static_cast<int>(c)]);
    }
    std::array<Estimate, 3> estimates;
    for (std::size_t c = 0; c < 3; ++c) {
        const Moments moments = momentsOf(means[c]);
        estimates[c] = {moments.mean, std::sqrt(moments.variance / static_cast<double>(moments.count))};
    }
    return estimates;
}
inline std::array<Estimate, 3> estimateRgb(const SceneArrays& scene, const RenderOptions& options,
                                           std::uint32_t seeds) {
    return estimateRgb(onReference(scene, options), seeds);
}
inline Estimate estimate(const FilmOfSeed& render, std::uint32_t seeds) { return estimateRgb(render, seeds)[0]; }
inline Estimate estimate(const SceneArrays& scene, const RenderOptions& options, std::uint32_t seeds) {
    return estimateRgb(scene, options, seeds)[0];
}

/// Within three standard errors of the truth, and of `model`, a relative error that the scene itself has, such as
/// facets that stand for a sphere.
inline void expectEstimates(const Estimate& e, double truth, double model = 1e-5) {
    EXPECT_NEAR(e.mean, truth, 3 * e.standardError + model * truth);
    EXPECT_LT(e.standardError, 0.02 * truth) << "too noisy to prove anything";
}

inline Material bsdfMaterial(std::string_view spec) {
    Material m;
    m.bsdf = parseBsdfSpec(spec);
    return m;
}

struct NamedId {
    std::uint32_t id;
    const char* name;
};
inline constexpr NamedId kEveryStrategy[] = {{kStrategyMisPower, "mis-power"},
                                             {kStrategyMisBalance, "mis-balance"},
                                             {kStrategyBsdf, "bsdf"},
                                             {kStrategyLight, "light"}};
inline constexpr NamedId kEveryHemisphere[] = {
    {kHemisphereBsdf, "bsdf"}, {kHemisphereUniform, "uniform"}, {kHemisphereCosine, "cosine"}};
inline constexpr NamedId kEveryRoulette[] = {
    {kRouletteOff, "off"}, {kRouletteThroughput, "throughput"}, {kRouletteFixed, "fixed"}};

inline void setRoulette(RenderParams& params, std::uint32_t mode) {
    params.rrMode = mode;
    params.rrDepth = 1;
    params.rrFixed = 0.8F;
}

}  // namespace vkpt::test
