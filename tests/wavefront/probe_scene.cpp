#include "wavefront/probe_scene.h"

#include "wavefront/kernels.h"
#include "wavefront/scene_upload.h"

namespace vkpt {

ProbeScene::ProbeScene(const SceneArrays& arrays, const RenderParams& params) : features_(arrays.features) {
    Device& device = testDevice();
    const SceneLayout layout = planScene(arrays);
    header_ = layout.header;
    struct {
        SceneHeader scene;
        RenderParams render;
    } const frame{header_, params};
    frame_ = Buffer(device, BufferUse::Uniform, sizeof frame, "probe frame");
    std::memcpy(frame_.map().data(), &frame, sizeof frame);
    scene_ = Buffer(device, BufferUse::Storage, layout.bytes, "probe scene");
    uploadScene(device, scene_, arrays, header_);
    dummy_ = Buffer(device, BufferUse::Storage, 16, "probe dummy");
    sceneTexels_ = TexelView(device, scene_, VK_FORMAT_R32G32B32A32_UINT, 0, layout.bytes);
    dummyTexels_ = TexelView(device, dummy_, VK_FORMAT_R32G32B32A32_UINT, 0, 16);
}

ProbeOptions ProbeScene::options(Fetch form, SamplerId sampler) const {
    const bool texel = form == Fetch::Texel;
    ProbeOptions options;
    options.specialization = specializationOf(features_, sampler, texel, false);
    options.extraKinds = {BindingKind::UniformBuffer, BindingKind::StorageBuffer, BindingKind::StorageTexel};
    options.extra = {frame_, texel ? dummy_ : scene_, texel ? sceneTexels_ : dummyTexels_};
    return options;
}

}  // namespace vkpt
