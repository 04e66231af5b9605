// SceneArrays packed into one buffer of 16-byte words on the device.
#pragma once
#include <cstdint>

#include "gpu/buffer.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct SceneLayout {
    SceneHeader header{};
    std::size_t bytes = 0;
};

/// Where each section starts. Throws DeviceError where the scene has 2^32 words or more.
[[nodiscard]] SceneLayout planScene(const SceneArrays& arrays);
/// Fills `buffer`, made for planScene's bytes.
void uploadScene(Device& device, const Buffer& buffer, const SceneArrays& arrays, const SceneHeader& header);

}  // namespace vkpt
