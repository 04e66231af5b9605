// SceneArrays packed into one buffer of 16-byte words on the device.
#pragma once
#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct SceneLayout {
    SceneHeader header{};
    std::vector<std::uint32_t> samplerTable;
    std::vector<FilterCell> filterTable;
    std::size_t bytes = 0;
};

/// Where each section starts. `lastIndex`: the highest sample index that kernels may meet. Throws DeviceError where the
/// scene has 2^32 words or more.
[[nodiscard]] SceneLayout planScene(const SceneArrays& arrays, SamplerChoice sampler, std::uint32_t lastIndex,
                                    const RenderParams& params = defaultParams());
/// Fills `buffer`, made for planScene's bytes.
void uploadScene(Device& device, const Buffer& buffer, const SceneArrays& arrays, const SceneLayout& layout);

}  // namespace vkpt
