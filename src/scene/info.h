// What `vkpt info` tells of a scene.
#pragma once
#include <string>

#include "base/json.h"
#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// Counts, bounds (metres), memory (bytes), cameras, lights, materials, extensions by support, and what was left out.
/// `arrays` may or may not have its BVH and environment: memory counts what is there.
[[nodiscard]] Json sceneInfo(const Scene& scene, const SceneArrays& arrays);

/// The same as a table for people; made from sceneInfo's result, so that both always agree.
[[nodiscard]] std::string sceneInfoText(const Json& info);

}  // namespace vkpt
