// How far points are from uniform.
#pragma once
#include <cstddef>

#include "analysis/point_set.h"

namespace vkpt {

/// The star discrepancy and a box [0,x) x [0,y), or [0,x] x [0,y], that attains it.
struct StarDiscrepancy {
    double value = 0;
    double x = 0, y = 0;
    std::size_t inside = 0;  ///< points in the box
    bool closed = false;     ///< the box holds its upper edges: there are too many points; else too few
};

/// Of points in two dimensions, exactly, over the grid of their coordinates. [Niederreiter 72] O(N^2).
[[nodiscard]] StarDiscrepancy starDiscrepancy(const PointSet& points);

/// L2 discrepancies in any number of dimensions, O(N^2).
[[nodiscard]] double l2Star(const PointSet& points);     ///< over boxes at the origin [Warnock 72]
[[nodiscard]] double l2Centred(const PointSet& points);  ///< boxes at the nearest corner [Hickernell 98]
[[nodiscard]] double l2Wrapped(const PointSet& points);  ///< boxes on the torus [Hickernell 98]

/// The root of the expected square of each for N independent uniform points.
[[nodiscard]] double randomL2Star(std::size_t n, std::size_t dims);
[[nodiscard]] double randomL2Centred(std::size_t n, std::size_t dims);
[[nodiscard]] double randomL2Wrapped(std::size_t n, std::size_t dims);
/// Star discrepancy of N independent uniform points of the plane, for which no closed form is known: the mean of
/// kRandomStarSets sets. O(N^2).
[[nodiscard]] double randomStar(std::size_t n);
inline constexpr std::uint32_t kRandomStarSets = 32;

}  // namespace vkpt
