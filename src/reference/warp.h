// Maps from the unit square to the domains that are sampled, with their densities.
#pragma once
#include <algorithm>

#include "reference/angle.h"

namespace vkpt::reference {

/// Concentric map to the unit disk; density 1/pi. [Shirley 97]
template <class Real>
[[nodiscard]] Vec2<Real> squareToDisk(const Vec2<Real>& u) {
    const Real a = 2 * u.x - 1, b = 2 * u.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    if (std::abs(a) > std::abs(b)) return a * cosSinTurns(b / a / 8);
    return b * cosSinTurns(Real(0.25) - a / b / 8);
}

/// Direction around +z with density cos/pi: the disk lifted to the hemisphere. [Malley 88]
template <class Real>
[[nodiscard]] Vec3<Real> squareToCosineHemisphere(const Vec2<Real>& u) {
    const Vec2<Real> disk = squareToDisk(u);
    return {disk, std::sqrt(std::max(Real(0), 1 - disk.x * disk.x - disk.y * disk.y))};
}

}  // namespace vkpt::reference
