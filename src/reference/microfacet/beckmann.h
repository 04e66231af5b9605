// The Beckmann-Spizzichino microfacet distribution with Smith's masking. Local frame, normal +z. [Walter 07], [Heitz
// 14]
#pragma once
#include <algorithm>

#include "reference/angle.h"
#include "reference/microfacet/erf.h"

namespace vkpt::reference {

/// Density of microfacet normals. [Heitz 14, eq. 82]
template <class Real>
[[nodiscard]] Real beckmannD(const Vec3<Real>& wm, Real alphaX, Real alphaY) {
    const Vec2<Real> slope(wm.x / (alphaX * wm.z), wm.y / (alphaY * wm.z));
    const Real height = std::exp(-glm::dot(slope, slope));
    if (!(height > 0)) return 0;  // z^4 may have underflown too
    const Real z2 = wm.z * wm.z;
    return height / (kPiOf<Real> * alphaX * alphaY * z2 * z2);
}

/// Smith's Lambda, exact. a = |cot theta| / alpha towards the direction, infinite at the normal. [Heitz 14, eq. 66]
template <class Real>
[[nodiscard]] Real beckmannLambda(Real a) {
    return std::max(Real(0), std::exp(-a * a) / (2 * a * kSqrtPi<Real>)-complementaryErrorFunction(a) / 2);
}

/// A normal with density D cos. [Walter 07, eqs. 28 and 29]
template <class Real>
[[nodiscard]] Vec3<Real> sampleBeckmannNormal(Real alphaX, Real alphaY, const Vec2<Real>& u) {
    const Vec2<Real> slope = std::sqrt(-std::log1p(-u.y)) * cosSinTurns(u.x);
    return glm::normalize(Vec3<Real>(alphaX * slope.x, alphaY * slope.y, 1));
}

/// Slopes beyond are left out: fewer than one facet in 2^24 has them.
inline constexpr int kLargestSlope = 5;

/// The slope towards the eye of a facet visible at angle theta from a surface of alpha 1: inverts the distribution
/// function of estimator.md at u by Newton's method within a bracket. [Jakob 14]
template <class Real>
[[nodiscard]] Real visibleBeckmannSlope(Real cosTheta, Real sinTheta, Real u) {
    const auto distribution = [&](Real x) {
        return cosTheta * complementaryErrorFunction(-x) + sinTheta * std::exp(-x * x) / kSqrtPi<Real>;
    };
    const Real cot = cosTheta / sinTheta;
    const Real goal = u * distribution(cot);
    Real low = -kLargestSlope, high = std::min(cot, Real(kLargestSlope)), x = std::min(Real(0), high / 2);
    constexpr int kSteps = std::is_same_v<Real, double> ? 56 : 32;
    for (int i = 0; i < kSteps; ++i) {
        const Real miss = distribution(x) - goal;
        (miss > 0 ? high : low) = x;
        const Real rise = 2 / kSqrtPi<Real> * std::exp(-x * x) * (cosTheta - x * sinTheta);
        const Real newton = x - miss / rise;
        x = newton >= low && newton <= high ? newton : (low + high) / 2;  // converged: it is one of them
    }
    return x;
}

/// A normal visible from wo, wo.z > 0. [Jakob 14]
template <class Real>
[[nodiscard]] Vec3<Real> sampleBeckmannVisibleNormal(const Vec3<Real>& wo, Real alphaX, Real alphaY,
                                                     const Vec2<Real>& u) {
    const Vec3<Real> w = glm::normalize(Vec3<Real>(alphaX * wo.x, alphaY * wo.y, wo.z));
    const Real sinTheta = std::sqrt(w.x * w.x + w.y * w.y);
    const Vec2<Real> phi = sinTheta > 0 ? Vec2<Real>(w.x, w.y) / sinTheta : Vec2<Real>(1, 0);
    const Real x = visibleBeckmannSlope(w.z, sinTheta, u.x);
    Real y = u.y > 0 ? inverseErrorFunction(2 * u.y - 1) : Real(-kLargestSlope);
    y = std::clamp(y, Real(-kLargestSlope), Real(kLargestSlope));
    const Vec2<Real> slope(x * phi.x - y * phi.y, x * phi.y + y * phi.x);
    return glm::normalize(Vec3<Real>(-alphaX * slope.x, -alphaY * slope.y, 1));
}

}  // namespace vkpt::reference
