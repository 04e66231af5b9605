// Cameras and lights that nodes carry. [glTF 2.0, §3.10; KHR_lights_punctual]
#pragma once
#include "gltf/document.h"
#include "gltf/nodes.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// Reads the camera or the light of a node into `scene`, where it carries one.
void readAttachments(const Document& document, const PlacedNode& placed, Scene& scene);

}  // namespace vkpt::gltf
