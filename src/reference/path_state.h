// Where a path stands, and what becomes of it at a surface.
#pragma once
#include <limits>
#include <optional>

#include "reference/geometry.h"
#include "reference/sampler.h"

namespace vkpt::reference {

/// Where a path stands before it traces segment `bounce` (0: the camera ray).
struct PathState {
    PathSample sample;
    std::uint32_t bounce = 0;
    std::uint32_t round = 0;  ///< of integrator direct: which of the samples of the first surface
    Ray ray;                  ///< unit direction
    glm::vec3 throughput{1};  ///< below 0 where the pixel filter is
    float pdfBsdf = std::numeric_limits<float>::infinity();  ///< of the ray's direction; infinite: MIS weight 1
    std::uint32_t medium = kNone;                            ///< material of the dielectric that the ray runs in

    /// The bounce whose random numbers and shadow key the surface uses that this segment meets.
    [[nodiscard]] std::uint32_t numbersOfSurface() const { return bounce + round; }
    /// The bounce whose key the alpha tests of this segment use: rounds share the camera ray.
    [[nodiscard]] std::uint32_t keyOfSegment() const { return bounce == 0 ? 0 : bounce + round; }
};

/// A light sample that is worth a shadow ray.
struct DirectLight {
    Ray shadowRay;  ///< anything at 0 < t < tMax is in the way
    float tMax = 1;
    glm::vec3 contribution{0};  ///< where nothing is
    std::uint32_t group = 0;    ///< the light's
};

/// What a path does where it meets a surface: steps 3 to 7.
struct PathVertex {
    ShadingPoint point;
    std::uint32_t material = 0;
    glm::vec3 emitted{0};  ///< contribution of the surface's own light
    std::optional<DirectLight> direct;
    std::optional<PathState> next;
};

}  // namespace vkpt::reference
