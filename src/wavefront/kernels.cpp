#include "wavefront/kernels.h"

#include <algorithm>
#include <bit>

#include "registry.h"
#include "wavefront/layout.h"

namespace vkpt {

std::uint32_t searchSteps(std::uint32_t count) {
    const std::uint32_t words = (count + 3) / 4;
    return words == 0 ? 0 : static_cast<std::uint32_t>(std::bit_width(words - 1));
}

std::vector<std::uint32_t> specializationOf(const SceneFeatures& f, const SceneHeader& header,
                                            const KernelOptions& options) {
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
            shadeGroupsOf(f.bsdfModels),
            f.multiscatter};
}

std::uint32_t shadeGroupsOf(std::uint32_t bsdfModels) {
    std::uint32_t groups = 0;
    for (const BsdfModelInfo& model : kBsdfModels)
        if ((bsdfModels >> static_cast<std::uint32_t>(model.id) & 1U) != 0)
            groups |= 1U << static_cast<std::uint32_t>(model.group);
    return groups;
}

WavefrontKernels::WavefrontKernels(Device& device, const SpirvSource& spirv,
                                   std::span<const std::uint32_t> specialization, std::uint32_t bsdfModels,
                                   bool useBallot, bool surfaceLayers) {
    const auto make = [&](std::string_view name) -> Kernel {
        return {device, spirv(name), kKernelBindings, sizeof(BatchParams), specialization, name};
    };
    generate = make("generate");
    intersect = make(useBallot ? "intersect" : "intersect_portable");
    for (std::size_t group = 0; group < shade.size(); ++group)
        if ((shadeGroupsOf(bsdfModels) >> group & 1U) != 0)
            shade[group].emplace(make(kStageNames[static_cast<std::size_t>(kShadeStages[group])] +
                                      std::string(useBallot ? "" : "_portable")));
    miss = make("miss");
    shadow = make("shadow");
    accumulate = make("accumulate");
    if (surfaceLayers) layers.emplace(make("layers"));
}

}  // namespace vkpt
