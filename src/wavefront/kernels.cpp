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

namespace {

Kernel makeKernel(Device& device, std::string_view name, std::span<const std::uint32_t> specialization) {
    return {device, kernelSpirv(name), kKernelBindings, sizeof(BatchParams), specialization, name};
}

}  // namespace

WavefrontKernels::WavefrontKernels(Device& device, std::span<const std::uint32_t> specialization, bool useBallot)
    : generate(makeKernel(device, "generate", specialization)),
      intersect(makeKernel(device, useBallot ? "intersect" : "intersect_portable", specialization)),
      shade(makeKernel(device, useBallot ? "shade" : "shade_portable", specialization)),
      miss(makeKernel(device, "miss", specialization)),
      shadow(makeKernel(device, "shadow", specialization)),
      accumulate(makeKernel(device, "accumulate", specialization)) {}

}  // namespace vkpt
