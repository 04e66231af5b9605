// Emissive triangles.
#pragma once
#include "reference/real.h"

namespace vkpt::reference {

/// Density per solid angle of a uniform point on a triangle, seen at distance^2 `distance2` under `cosine` > 0.
template <class Real>
[[nodiscard]] Real trianglePdf(Real area, Real distance2, Real cosine) {
    return distance2 / (area * cosine);
}

}  // namespace vkpt::reference
