#include "wavefront/kernels.h"

#include "wavefront/layout.h"

namespace vkpt {

std::vector<std::uint32_t> specializationOf(const SceneFeatures& f, SamplerId sampler, bool fetchTexel, bool useBallot,
                                            bool stateTexel) {
    return {static_cast<std::uint32_t>(sampler),
            fetchTexel,
            f.instances,
            f.alpha,
            f.textures,
            f.normalMaps,
            f.vertexExtras,
            f.triangleLights,
            f.texturedEmission,
            f.punctualLights,
            f.environment,
            f.unlit,
            useBallot,
            stateTexel,
            f.textureTransforms};
}

WavefrontKernels::WavefrontKernels(Device& device, const SpirvSource& spirv,
                                   std::span<const std::uint32_t> specialization, bool useBallot) {
    const auto make = [&](std::string_view name) -> Kernel {
        return {device, spirv(name), kKernelBindings, sizeof(BatchParams), specialization, name};
    };
    generate = make("generate");
    intersect = make(useBallot ? "intersect" : "intersect_portable");
    shade = make(useBallot ? "shade" : "shade_portable");
    miss = make("miss");
    shadow = make("shadow");
    accumulate = make("accumulate");
}

}  // namespace vkpt
