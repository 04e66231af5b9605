// Adaptive quadrature over the directions of a hemisphere, for functions with narrow peaks.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace vkpt {

/// A square of the equal-area map from the unit square to a hemisphere: the concentric map to the disk [Shirley 97],
/// then Lambert's azimuthal projection.
struct SphereCell {
    bool upper = true;  ///< z > 0
    double x = 0, y = 0, size = 1;
};

/// Unit direction of a point of the unit square.
[[nodiscard]] glm::dvec3 directionOfSquare(const glm::dvec2& u, bool upper);
/// The reverse, whichever the hemisphere.
[[nodiscard]] glm::dvec2 squareOfDirection(const glm::dvec3& w);

struct QuadratureConfig {
    double tolerance = 1e-5;  ///< of one cell: a finer estimate that differs by less is taken
    int leastDepth = 2;       ///< halvings of the whole square that are made anyway
    int peakDepth = 8;        ///< the same where a peak lies
    int mostDepth = 12;       ///< where no peak is: an edge of f ends here
};

using DirectionFunction = std::function<glm::dvec4(const glm::dvec3&)>;

/// Integral of f per solid angle over a cell. `peaks`: directions about which f is narrow.
[[nodiscard]] glm::dvec4 integrate(const DirectionFunction& f, const SphereCell& cell,
                                   std::span<const glm::dvec3> peaks = {}, const QuadratureConfig& config = {});

}  // namespace vkpt
