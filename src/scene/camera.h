// Cameras: fill the view of a RenderParams (eye, right, up, forward, projection).
// RenderParams.width and height must be set before: the aspect of the window is theirs.
#pragma once
#include <glm/glm.hpp>
#include <string_view>

#include "layout.h"
#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

inline constexpr float kDefaultFov = 45;  ///< degrees, vertical

/// Perspective camera at `eye` that looks at `target`, +y up (-z up where it looks straight up or down).
/// `fov` in degrees, vertical. Throws Error(Usage) where both points are the same or fov is outside (0, 180).
void lookAt(RenderParams& params, const glm::vec3& eye, const glm::vec3& target, float fov = kDefaultFov);

/// Perspective camera at target + radius (sin phi sin theta, cos phi, sin phi cos theta), angles in degrees, that looks
/// at the target; its up follows phi through the poles. Radius 0 stands at the target and looks the same way.
/// Throws Error(Usage) for a negative radius or a fov outside (0, 180).
void orbit(RenderParams& params, float theta, float phi, float radius, const glm::vec3& target,
           float fov = kDefaultFov);

/// Three-quarter view from the front right, a little above: the nearest eye from which the whole scene is visible,
/// centred, with a small margin. Works before and after buildBvh.
void frameScene(RenderParams& params, const SceneArrays& arrays, float fov = kDefaultFov);

/// The file's camera. The window keeps its vertical size (yfov, ymag); width follows the image's aspect.
/// Throws FileError where its node has no usable orientation.
void fromCamera(RenderParams& params, const Scene& scene, const Camera& camera);

/// Turns the view into another projection (kProjection*). An orthographic one shows what the perspective one shows at
/// `distance` metres, and the reverse; a panorama looks forward in its middle. Requires that the view is no panorama.
void setProjection(RenderParams& params, std::uint32_t projection, float distance);

/// Scales the window of a view to this half height: metres of an orthographic one, tan(fov/2) of a perspective one.
void setHalfHeight(RenderParams& params, float halfHeight);

/// By name, else by index in the order of the file. Throws FileError, naming the cameras there are.
[[nodiscard]] const Camera& findCamera(const Scene& scene, std::string_view nameOrIndex);

}  // namespace vkpt
