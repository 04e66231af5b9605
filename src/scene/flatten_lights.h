// The lights: emissive triangles and punctual lights of a scene, and the table by which one is chosen.
#pragma once
#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// Appends a LightRecord for every emissive triangle and every punctual light, then makes the table.
/// Geometry and materials must be in place. An emissive triangle gets no light (its emission is then found by
/// paths that happen to hit it, with MIS weight 1) where its texture is black all over, and where it may be
/// transparent: light samples do not see a light's own alpha.
void flattenLights(const Scene& scene, SceneArrays& arrays);

/// Recomputes lightCdf and every pmf from lightPower.
void buildLightTable(SceneArrays& arrays);

/// Radius in metres of the sphere around the scene's bounds; 1 where there is no geometry.
[[nodiscard]] float sceneRadius(const SceneArrays& arrays);

}  // namespace vkpt
