// Normals where a file has none.
#pragma once
#include "scene/scene.h"

namespace vkpt::gltf {

/// Gives every triangle vertices of its own with its geometric normal. [glTF 2.0, §3.7.2.1]
void makeFlat(Primitive& primitive);

}  // namespace vkpt::gltf
