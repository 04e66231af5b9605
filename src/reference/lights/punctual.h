// Point, spot and directional lights. [KHR_lights_punctual]
#pragma once
#include <algorithm>

#include "reference/real.h"

namespace vkpt::reference {

/// Smooth end of a light at `range` metres; 1 where range is 0 (infinite).
template <class Real>
[[nodiscard]] Real rangeWindow(Real distance2, Real range) {
    if (range <= 0) return 1;
    const Real q2 = distance2 / (range * range);
    return std::clamp(1 - q2 * q2, Real(0), Real(1));
}

/// Falloff between the cones, at the cosine of the angle from the beam's axis.
template <class Real>
[[nodiscard]] Real spotFalloff(Real cosine, Real scale, Real offset) {
    const Real f = std::clamp(cosine * scale + offset, Real(0), Real(1));
    return f * f;
}

}  // namespace vkpt::reference
