#include "verify/prober.h"

#include "wavefront/kernels.h"
#include "wavefront/scene_upload.h"

namespace vkpt {

const Kernel& Prober::kernel(const std::string& name, const ProbeOptions& options) {
    const auto key = std::pair(name, options.specialization);
    const auto found = kernels_.find(key);
    if (found != kernels_.end()) return found->second;
    return kernels_.emplace(key, makeProbeKernel(device_, spirv_(name), name, options)).first->second;
}

ProbeScene::ProbeScene(Prober& prober, const SceneArrays& arrays, const RenderParams& params, SamplerChoice sampler,
                       std::uint32_t lastIndex)
    : prober_(prober),
      features_(arrays.features),
      sampler_(sampler),
      lastIndex_(lastIndex),
      listTriangles_(listTriangles(arrays, params.integrator)),
      stackEntries_(stackEntries(arrays)) {
    Device& device = prober.device();
    const SceneLayout layout = planScene(arrays, sampler, lastIndex);
    header_ = layout.header;
    const Frame frame = makeFrame(layout, params);
    frame_ = Buffer(device, BufferUse::Uniform, sizeof frame, "probe frame");
    std::memcpy(frame_.map().data(), &frame, sizeof frame);
    scene_ = Buffer(device, BufferUse::Storage, layout.bytes, "probe scene");
    uploadScene(device, scene_, arrays, layout);
    dummy_ = Buffer(device, BufferUse::Storage, 16, "probe dummy");
    sceneTexels_ = TexelView(device, scene_, VK_FORMAT_R32G32B32A32_UINT, 0, layout.bytes);
    dummyTexels_ = TexelView(device, dummy_, VK_FORMAT_R32G32B32A32_UINT, 0, 16);
}

ProbeOptions ProbeScene::options(Fetch form) const {
    const bool texel = form == Fetch::Texel;
    ProbeOptions options;
    options.specialization = specializationOf(features_, header_,
                                              {.sampler = sampler_,
                                               .lastIndex = lastIndex_,
                                               .fetchTexel = texel,
                                               .listTriangles = texel ? listTriangles_ : 0,
                                               .stackEntries = texel ? stackEntries_ : kMaxStackEntries});
    options.extraKinds = {BindingKind::UniformBuffer, BindingKind::StorageBuffer, BindingKind::StorageTexel};
    options.extra = {frame_, texel ? dummy_ : scene_, texel ? sceneTexels_ : dummyTexels_};
    return options;
}

}  // namespace vkpt
