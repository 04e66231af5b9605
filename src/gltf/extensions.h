// Which extensions of a file are honoured.
#pragma once
#include "gltf/document.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// Throws FileError where the file requires an extension that is not supported.
void requireSupported(const Document& document, const Json& root);

/// Fills Scene::extensions and Scene::ignored, with a warning for each extension or feature that has no effect.
void reportExtensions(const Document& document, Scene& scene);

}  // namespace vkpt::gltf
