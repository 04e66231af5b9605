// Camera rays. estimator.md, Frame and camera.
#pragma once
#include "layout.h"
#include "reference/hit.h"
#include "reference/real.h"

namespace vkpt::reference {

/// The ray through film position (x, y) in pixels, row 0 at the top; a unit direction.
[[nodiscard]] inline Ray cameraRay(const RenderParams& params, const Vec2<float>& film) {
    const float s = 2 * film.x / static_cast<float>(params.width) - 1;
    const float t = 1 - 2 * film.y / static_cast<float>(params.height);
    const glm::vec3 offset = s * params.right + t * params.up;
    if (params.projection == kProjectionOrthographic) return {params.eye + offset, params.forward};
    return {params.eye, glm::normalize(params.forward + offset)};
}

}  // namespace vkpt::reference
