#include "wavefront/kernels.h"

#include <algorithm>
#include <bit>

#include "registry.h"
#include "scene/pixel_filter.h"
#include "wavefront/layout.h"

namespace vkpt {

std::uint32_t searchSteps(std::uint32_t count) {
    const std::uint32_t words = (count + 3) / 4;
    return words == 0 ? 0 : static_cast<std::uint32_t>(std::bit_width(words - 1));
}

namespace {

/// Exponents of the heuristic that need no power; 0: another.
std::uint32_t foldedBeta(const RenderParams& p) {
    if (p.strategy == kStrategyMisBalance || p.beta == 1) return 1;
    return p.beta == 2 ? 2 : 0;
}

}  // namespace

std::vector<std::uint32_t> specializationOf(const SceneFeatures& f, const SceneHeader& header,
                                            const KernelOptions& options) {
    const RenderParams& p = options.params;
    const auto indexDigits = std::max<std::uint32_t>((std::bit_width(options.lastIndex) + 3U) / 4, 1);
    return {static_cast<std::uint32_t>(options.sampler.id),
            options.fetchTexel,
            f.instances,
            f.alpha,
            f.maps,
            f.vertexExtras,
            f.triangleLights,
            f.texturedEmission,
            f.punctualLights,
            f.environment,
            f.unlit,
            options.useBallot,
            options.stateTexel,
            f.textureTransforms,
            f.mapSets,
            indexDigits,
            searchSteps(header.lightCount),
            searchSteps(header.envHeight),
            searchSteps(header.envWidth),
            static_cast<std::uint32_t>(options.sampler.scramble),
            options.film.words(),
            options.film.firstWord(Layer::Albedo),
            options.film.firstWord(Layer::Normal),
            options.film.firstWord(Layer::Depth),
            options.film.firstWord(Layer::Position),
            options.film.firstWord(Layer::Uv),
            options.film.firstWord(Layer::Ids),
            options.film.firstWord(Layer::Luminance),
            options.setSamples,
            f.bsdfModels,
            shadeGroupsOf(f.bsdfModels, p.integrator),
            f.multiscatter,
            p.integrator,
            p.strategy,
            foldedBeta(p),
            p.hemisphere,
            p.projection,
            header.filterTable != kNone,
            p.lensRadius > 0 && p.projection != kProjectionPanorama,
            f.media,
            hasNegativeLobes(p.pixelFilter),
            options.film.lengthWord(),
            std::max(options.film.light().lengths, 1U),
            options.film.groupWord(),
            options.listTriangles,
            options.stackEntries,
            options.inlineShadows};
}

std::uint32_t listTriangles(const SceneArrays& arrays, std::uint32_t integrator) {
    const bool listed = !arrays.features.instances && !arrays.features.alpha && arrays.triangles.size() <= kListMax;
    const bool showsTree = integrator == static_cast<std::uint32_t>(IntegratorId::Cost);
    return listed && !showsTree ? static_cast<std::uint32_t>(arrays.triangles.size()) : 0;
}

std::uint32_t stackEntries(const SceneArrays& arrays) { return std::max(arrays.bvhDepth, 2U) - 1; }

bool needsNoBsdf(std::uint32_t integrator) {
    switch (static_cast<IntegratorId>(integrator)) {
        case IntegratorId::Path:
        case IntegratorId::Direct:
        case IntegratorId::LightProbability:
            return false;
        default:
            return true;
    }
}

std::uint32_t shadeGroupsOf(std::uint32_t bsdfModels, std::uint32_t integrator) {
    if (needsNoBsdf(integrator)) return 1U << kGroupGltf;
    std::uint32_t groups = 0;
    for (const BsdfModelInfo& model : kBsdfModels)
        if ((bsdfModels >> static_cast<std::uint32_t>(model.id) & 1U) != 0)
            groups |= 1U << static_cast<std::uint32_t>(model.group);
    return groups;
}

WavefrontKernels::WavefrontKernels(Device& device, const SpirvSource& spirv, const SceneFeatures& features,
                                   const SceneHeader& header, const KernelOptions& options) {
    const std::vector<std::uint32_t> specialization = specializationOf(features, header, options);
    const auto make = [&](std::string_view name) -> Kernel {
        return {device, spirv(name), kKernelBindings, sizeof(BatchParams), specialization, name};
    };
    const std::string form = options.useBallot ? "" : "_portable";
    generate = make("generate");
    intersect = make("intersect" + form);
    const bool look = needsNoBsdf(options.params.integrator);
    for (std::size_t group = 0; group < shade.size(); ++group)
        if ((shadeGroupsOf(features.bsdfModels, options.params.integrator) >> group & 1U) != 0)
            shade[group].emplace(
                make((look ? "look" : kStageNames[static_cast<std::size_t>(kShadeStages[group])]) + form));
    miss = make("miss");
    if (!options.inlineShadows) shadow.emplace(make("shadow"));
    accumulate = make("accumulate");
    if (options.film.hasSurfaceLayer()) layers.emplace(make("layers"));
}

}  // namespace vkpt
