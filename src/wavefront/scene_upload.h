// SceneArrays packed into one buffer of 16-byte words on the device.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// The uniform block of shaders/geometry/fetch.glsl.
struct Frame {
    SceneHeader header;
    RenderParams params;
    std::array<TriangleRecord, kListMax> list;  ///< of the triangles, where there are no more
};

struct SceneLayout {
    SceneHeader header{};
    std::vector<std::uint32_t> samplerTable;
    std::vector<FilterCell> filterTable;
    std::vector<TriangleRecord> list;  ///< empty: too long
    std::size_t bytes = 0;
};

/// Where each section starts. `lastIndex`: the highest sample index that kernels may meet. Throws DeviceError where the
/// scene has 2^32 words or more.
[[nodiscard]] SceneLayout planScene(const SceneArrays& arrays, SamplerChoice sampler, std::uint32_t lastIndex,
                                    const RenderParams& params = defaultParams());
[[nodiscard]] Frame makeFrame(const SceneLayout& layout, const RenderParams& params);
/// Fills `buffer`, made for planScene's bytes.
void uploadScene(Device& device, const Buffer& buffer, const SceneArrays& arrays, const SceneLayout& layout);

}  // namespace vkpt
