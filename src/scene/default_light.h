// When a scene is dark by itself and the built-in studio should light it.
#pragma once
#include "scene/scene_arrays.h"

namespace vkpt {

/// The scene has something that is meant to light it: a punctual light, or a placed surface that emits evenly. Emission
/// through a texture (a screen, a glowing visor) does not count: such models are made to be lit from outside.
/// A scene without a light gets the studio.
[[nodiscard]] bool hasOwnLight(const SceneArrays& arrays);

}  // namespace vkpt
