// specializationOf (src/wavefront/kernels.cpp) sets the constants that shaders/specialization.glsl means.
#include <array>

#include "registry.h"
#include "verify/context.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

struct Constants {
    SceneFeatures features;
    SceneHeader header{};
    KernelOptions options;
};

using Named = std::pair<const char*, std::uint32_t>;

std::uint32_t expectedBeta(const RenderParams& p) {
    const float beta = p.strategy == kStrategyMisBalance ? 1 : p.beta;
    return beta == 1 || beta == 2 ? static_cast<std::uint32_t>(beta) : 0;
}

/// All constants by name, in the order in which the probe writes them.
std::array<Named, 47> namesAndValues(const Constants& c) {
    const auto& [f, h, o] = c;
    const auto flag = [](bool b) { return b ? 1U : 0U; };
    return {Named{"kSampler", static_cast<std::uint32_t>(o.sampler.id)},
            {"kFetchTexel", flag(o.fetchTexel)},
            {"kHasInstances", flag(f.instances)},
            {"kHasAlpha", flag(f.alpha)},
            {"kSceneMaps", f.maps},
            {"kHasVertexExtras", flag(f.vertexExtras)},
            {"kHasTriangleLights", flag(f.triangleLights)},
            {"kHasTexturedEmission", flag(f.texturedEmission)},
            {"kHasPunctualLights", flag(f.punctualLights)},
            {"kHasEnvironment", flag(f.environment)},
            {"kHasUnlit", flag(f.unlit)},
            {"kUseBallot", flag(o.useBallot)},
            {"kStateTexel", flag(o.stateTexel)},
            {"kHasTransforms", flag(f.textureTransforms)},
            {"kMapSets", f.mapSets},
            {"kIndexDigits", 3},
            {"kLightSteps", searchSteps(h.lightCount)},
            {"kRowSteps", searchSteps(h.envHeight)},
            {"kColumnSteps", searchSteps(h.envWidth)},
            {"kScramble", static_cast<std::uint32_t>(o.sampler.scramble)},
            {"kLayerWords", o.film.words()},
            {"kAlbedoWord", o.film.firstWord(Layer::Albedo)},
            {"kNormalWord", o.film.firstWord(Layer::Normal)},
            {"kDepthWord", o.film.firstWord(Layer::Depth)},
            {"kPositionWord", o.film.firstWord(Layer::Position)},
            {"kUvWord", o.film.firstWord(Layer::Uv)},
            {"kIdsWord", o.film.firstWord(Layer::Ids)},
            {"kLuminanceWord", o.film.firstWord(Layer::Luminance)},
            {"kSetSamples", o.setSamples},
            {"kBsdfModels", f.bsdfModels},
            {"kShadeGroups", 1U << kGroupMicrofacet | 1U << kGroupClassic},
            {"kMultiscatter", flag(f.multiscatter)},
            {"kIntegrator", o.params.integrator},
            {"kStrategy", o.params.strategy},
            {"kBeta", expectedBeta(o.params)},
            {"kHemisphere", o.params.hemisphere},
            {"kProjection", o.params.projection},
            {"kHasFilter", flag(h.filterTable != kNone)},
            {"kHasLens", flag(o.params.lensRadius > 0 && o.params.projection != kProjectionPanorama)},
            {"kHasMedia", flag(f.media)},
            {"kHasNegativeLobes", flag(o.params.pixelFilter == kFilterMitchell)},
            {"kLengthWord", o.film.lengthWord()},
            {"kLengthLayers", std::max(o.film.light().lengths, 1U)},
            {"kGroupWord", o.film.groupWord()},
            {"kListTriangles", o.listTriangles},
            {"kStackEntries", o.stackEntries},
            {"kInlineShadows", flag(o.inlineShadows)}};
}

/// Round `bit` of a set in which no two flags are the same in all rounds; the numbers differ in any.
Constants makeConstants(std::uint32_t bit) {
    Constants c;
    auto& [f, h, o] = c;
    std::uint32_t number = 0;
    for (bool* flag : {&f.instances, &f.alpha, &f.textureTransforms, &f.vertexExtras, &f.triangleLights,
                       &f.texturedEmission, &f.punctualLights, &f.environment, &f.unlit, &f.multiscatter, &f.media,
                       &o.fetchTexel, &o.useBallot, &o.stateTexel, &o.inlineShadows})
        *flag = (++number >> bit & 1U) != 0;
    f.maps = 13;
    f.bsdfModels = 1U << static_cast<std::uint32_t>(BsdfId::Eon) | 1U << static_cast<std::uint32_t>(BsdfId::Dielectric);
    f.mapSets = 9;
    h.lightCount = 1000;
    h.envHeight = 64;
    h.envWidth = 4000;
    o.sampler = {static_cast<SamplerId>(7), static_cast<ScrambleId>(5)};
    o.lastIndex = 0xabc;  // three hexadecimal digits
    o.setSamples = 77;
    o.listTriangles = 21;
    o.stackEntries = 19;
    if (bit % 2 == 0) o.film = FilmLayout(kAllAovs, {7, {"a", "b"}});
    RenderParams& p = o.params;
    p.integrator = static_cast<std::uint32_t>(bit % 2 == 0 ? IntegratorId::Direct : IntegratorId::LightProbability);
    p.strategy = bit == 3 ? kStrategyMisBalance : kStrategyMisPower;
    p.beta = bit == 0 ? 1.5F : static_cast<float>(bit);
    p.hemisphere = bit % 2 == 0 ? kHemisphereUniform : kHemisphereCosine;
    const auto next = [&] { return (++number >> bit & 1U) != 0; };
    p.lensRadius = 0.25F;
    p.projection = next() ? kProjectionOrthographic : kProjectionPanorama;  // the latter without a lens
    h.filterTable = next() ? 3 : kNone;
    p.pixelFilter = next() ? kFilterMitchell : kFilterGaussian;
    return c;
}

}  // namespace

void checkSpecialization(VerifyContext& context, Findings& findings) {
    constexpr std::uint32_t kRounds = 5;  // 18 flags
    for (std::uint32_t round = 0; round < kRounds; ++round) {
        const Constants constants = makeConstants(round);
        ProbeOptions options;
        options.specialization = specializationOf(constants.features, constants.header, constants.options);
        const auto read = context.prober().evaluate<std::array<std::uint32_t, 48>>(
            "specialization", std::vector<glm::uvec4>(1), options)[0];
        const auto expected = namesAndValues(constants);
        const auto scope = findings.inputs([&](std::size_t i) { return std::string(expected[i].first); });
        findings.equal("number of constants", options.specialization.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            findings.at(i);
            findings.equal("constants", read[i], expected[i].second);
        }
    }
}

}  // namespace vkpt
