// Trigonometry from published polynomials, so that both renderers round alike. estimator.md, Numbers. [Moshier 89]
// Real = double is the truth and uses the standard library.
#pragma once
#include <type_traits>

#include "reference/real.h"

namespace vkpt::reference {

/// (cos, sin) of an angle in turns.
template <class Real>
[[nodiscard]] Vec2<Real> cosSinTurns(Real turns) {
    if constexpr (std::is_same_v<Real, double>) {
        return {std::cos(2 * kPiOf<Real> * turns), std::sin(2 * kPiOf<Real> * turns)};
    } else {
        const Real k = std::floor(4 * turns + Real(0.5));
        const Real r = 2 * kPiOf<Real> * (turns - k / 4);
        const Real r2 = r * r;
        const Real s =
            r *
            (1 + r2 * (Real(-1.0 / 6) + r2 * (Real(1.0 / 120) + r2 * (Real(-1.0 / 5040) + r2 * Real(1.0 / 362880)))));
        const Real c = 1 + r2 * (Real(-0.5) + r2 * (Real(1.0 / 24) + r2 * (Real(-1.0 / 720) + r2 * Real(1.0 / 40320))));
        switch (static_cast<int>(k) & 3) {
            case 0:
                return {c, s};
            case 1:
                return {-s, c};
            case 2:
                return {-c, -s};
            default:
                return {s, -c};
        }
    }
}

/// Angle of (x, y) in radians, in [-pi, pi]; 0 at the origin.
template <class Real>
[[nodiscard]] Real arcTangent2(Real y, Real x) {
    if constexpr (std::is_same_v<Real, double>) {
        return std::atan2(y, x);
    } else {
        if (x == 0 && y == 0) return 0;
        constexpr Real kTan3PiOver8 = Real(2.414213562373095), kTanPiOver8 = Real(0.4142135623730950);
        Real ratio = std::abs(y) / std::abs(x);
        Real angle = 0;
        if (ratio > kTan3PiOver8) {
            angle = kPiOf<Real> / 2;
            ratio = -1 / ratio;
        } else if (ratio > kTanPiOver8) {
            angle = kPiOf<Real> / 4;
            ratio = (ratio - 1) / (ratio + 1);
        }
        const Real z = ratio * ratio;
        angle += (((Real(8.05374449538e-2) * z - Real(1.38776856032e-1)) * z + Real(1.99777106478e-1)) * z -
                  Real(3.33329491539e-1)) *
                     z * ratio +
                 ratio;
        if (x < 0) angle = kPiOf<Real> - angle;
        return y < 0 ? -angle : angle;
    }
}

/// Arc cosine of y in [-1, 1], in radians.
template <class Real>
[[nodiscard]] Real arcCosine(Real y) {
    return arcTangent2(std::sqrt(std::max(Real(0), (1 - y) * (1 + y))), y);
}

}  // namespace vkpt::reference
