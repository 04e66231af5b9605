// Which extensions of a file are honoured.
#pragma once
#include "gltf/document.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// Fills Scene::extensions and Scene::ignored, with a warning for each extension or feature that has no effect.
/// Throws FileError for a required extension that is not supported.
void reportExtensions(const Document& document, Scene& scene);

}  // namespace vkpt::gltf
