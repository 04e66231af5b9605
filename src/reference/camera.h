// Camera rays. estimator.md, Frame and camera.
#pragma once
#include <span>

#include "layout.h"
#include "reference/hit.h"
#include "reference/warp.h"

namespace vkpt::reference {

/// Where in, or around, its pixel a sample lies, and how much it counts there.
struct FilmPlace {
    Vec2<float> position;  ///< from the pixel's upper left corner
    float weight = 1;      ///< below 0 where the filter is
};

/// Draws from a pixel filter; `cells` is its table, empty for the box of one pixel. [Ernst 06]
[[nodiscard]] inline FilmPlace sampleFilter(std::span<const FilterCell> cells, const Vec2<float>& u) {
    if (cells.empty()) return {u};
    FilmPlace place{Vec2<float>(0.5F)};
    for (int axis = 0; axis < 2; ++axis) {
        const float t = static_cast<float>(kFilterSteps) * u[axis];
        const auto i = static_cast<std::uint32_t>(t);  // below kFilterSteps, as u is below 1
        const FilterCell& cell = cells[i];
        place.position[axis] += glm::mix(cell.begin, cell.end, t - static_cast<float>(i));
        place.weight *= cell.weight;
    }
    return place;
}

/// Equirectangular: `forward` in the middle, `up` at the top; s and t run over [-1, 1].
[[nodiscard]] inline glm::vec3 panoramaDirection(const RenderParams& params, float s, float t) {
    const Vec2<float> phi = cosSinTurns(s / 2), theta = cosSinTurns((1 - t) / 4);
    return theta.y * (phi.x * params.forward + phi.y * params.right) + theta.x * params.up;
}

/// The ray through film position (x, y) in pixels, row 0 at the top; a unit direction.
[[nodiscard]] inline Ray cameraRay(const RenderParams& params, const Vec2<float>& film) {
    const float s = 2 * film.x / static_cast<float>(params.width) - 1;
    const float t = 1 - 2 * film.y / static_cast<float>(params.height);
    if (params.projection == kProjectionPanorama) return {params.eye, panoramaDirection(params, s, t)};
    const glm::vec3 offset = s * params.right + t * params.up;
    if (params.projection == kProjectionOrthographic) return {params.eye + offset, params.forward};
    return {params.eye, glm::normalize(params.forward + offset)};
}

/// The ray from another point of the lens that meets `pinhole` at the focus distance.
[[nodiscard]] inline Ray lensRay(const RenderParams& params, const Ray& pinhole, const Vec2<float>& u) {
    const float reach = params.focusDistance / glm::dot(pinhole.direction, params.forward);
    const glm::vec3 focus = pinhole.origin + pinhole.direction * reach;
    const Vec2<float> lens = params.lensRadius * squareToDisk(u);
    const glm::vec3 origin =
        pinhole.origin + lens.x * glm::normalize(params.right) + lens.y * glm::normalize(params.up);
    return {origin, glm::normalize(focus - origin)};
}

}  // namespace vkpt::reference
