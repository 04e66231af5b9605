// The filters of FLIP, each a product of two one-dimensional ones. [Andersson 20, secs. 4.1 and 4.2]
#pragma once
#include <cstddef>
#include <vector>

namespace vkpt {

/// Weights in one direction, the middle one that of the pixel itself; lengths are odd.
struct FlipFilters {
    std::size_t radius = 0;  ///< pixels that the longest filter reaches to each side
    /// Contrast sensitivity of the eye: applied along both axes each sums to 1 over the plane; that of Cz is the sum of
    /// two.
    std::vector<float> y, cx, czNarrow, czWide;
    /// Detectors of edges and points: `gauss` along one axis, a derivative along the other. Positive weights of a
    /// derivative sum to 1, negative ones to -1.
    std::vector<float> gauss, edge, point;
};

/// `pixelsPerDegree` is above 0.
[[nodiscard]] FlipFilters makeFlipFilters(double pixelsPerDegree);

}  // namespace vkpt
