#include "cli/estimator_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/command.h"
#include "scene/pixel_filter.h"

namespace vkpt {
namespace {

bool computesLight(IntegratorId id) { return id == IntegratorId::Path || id == IntegratorId::Direct; }

void checkDirect(const SamplingOptions& s) {
    const bool light = s.lightSamples > 0, bsdf = s.bsdfSamples > 0;
    if (!light && !bsdf)
        throw usageError("--bsdf-samples", "is 0, and so is --light-samples: nothing would be computed");
    if (s.strategy == Strategy::Bsdf && !bsdf)
        throw usageError("--bsdf-samples", "is 0, and --strategy bsdf takes no others: nothing would be computed");
    if (s.strategy == Strategy::Light && !light)
        throw usageError("--light-samples",
                         "is 0, and --strategy light finds light by them: nothing would be computed");
}

}  // namespace

void checkEstimator(const SamplingOptions& s) {
    if (s.aovs.has(Aov::Variance) && hasNegativeLobes(s.filter.id))
        throw usageError("--aov", "variance needs a --filter that takes no light away: mitchell does");
    if (s.perBounce && !computesLight(s.integrator))
        throw usageError("--per-bounce", "needs --integrator path or direct");
    if (s.lightGroups.on && !computesLight(s.integrator))
        throw usageError("--light-groups", "needs --integrator path or direct");
    if (s.integrator == IntegratorId::Direct) checkDirect(s);
}

std::vector<std::string> idleOptions(const SceneOptions& scene, const SamplingOptions& s) {
    const SamplingOptions by;  // default
    const bool path = s.integrator == IntegratorId::Path, direct = s.integrator == IntegratorId::Direct;
    const bool ao = s.integrator == IntegratorId::Ao, light = path || direct;
    const bool directions = light || ao || s.integrator == IntegratorId::LightProbability;
    const bool roulette = s.roulette.mode != by.roulette.mode || s.rrDepth != by.rrDepth;
    const bool noLightSamples = direct && s.strategy == Strategy::Bsdf;
    const struct {
        bool idle;
        const char *option, *why;
    } cases[] = {
        {!light && s.maxDepth != by.maxDepth, "--max-depth", "without --integrator path or direct"},
        {direct && s.maxDepth > 1 && s.maxDepth != by.maxDepth, "--max-depth above 1", "with --integrator direct"},
        {!path && roulette, "--rr", "without --integrator path"},
        {!light && s.strategy != by.strategy, "--strategy", "without --integrator path or direct"},
        {!light && s.beta != by.beta, "--beta", "without --integrator path or direct"},
        {light && s.strategy != Strategy::MisPower && s.beta != by.beta, "--beta", "without --strategy mis-power"},
        {!directions && s.hemisphere != by.hemisphere, "--hemisphere", "without --integrator path, direct or ao"},
        {!direct && s.bsdfSamples != by.bsdfSamples, "--bsdf-samples", "without --integrator direct"},
        {!direct && s.lightSamples != by.lightSamples, "--light-samples", "without --integrator direct"},
        {noLightSamples && s.lightSamples != by.lightSamples, "--light-samples", "with --strategy bsdf"},
        {!ao && std::isfinite(s.aoDistance), "--ao-distance", "without --integrator ao"},
        {!path && s.clampIndirect > 0, "--clamp-indirect", "without --integrator path"},
        {scene.focus && scene.aperture == 0, "--focus", "without --aperture"},
        {scene.fov && scene.projection == Projection::Panorama, "--fov", "with --projection panorama"},
    };
    std::vector<std::string> lines;
    for (const auto& [idle, option, why] : cases)
        if (idle) lines.push_back(fmt::format("{} has no effect {}", option, why));
    return lines;
}

std::string unfoundLight(const SceneArrays& arrays, const RenderParams& params) {
    const bool direct = params.integrator == static_cast<std::uint32_t>(IntegratorId::Direct);
    const bool byStrategy = params.strategy == kStrategyBsdf;
    if (pathDepth(params) == 0 || !(byStrategy || (direct && params.lightSamples == 0))) return {};
    const auto dark = std::ranges::count_if(arrays.lights, [](const LightRecord& light) {
        return light.kind == kLightPoint || light.kind == kLightSpot || light.kind == kLightDirectional;
    });
    if (dark == 0) return {};
    return fmt::format(
        "{} finds light by chance, which never meets point, spot and directional lights; how many stay dark: {}",
        byStrategy ? "--strategy bsdf" : "--light-samples 0", dark);
}

}  // namespace vkpt
