// Reflectance of smooth boundaries: Schlick's approximation [Schlick 94], dielectrics [Walter 07], metals [Born 99].
#pragma once
#include <algorithm>

#include "reference/real.h"

namespace vkpt::reference {

/// (1 - cosine)^5: how far reflectance has gone from F0 to 1.
template <class Real>
[[nodiscard]] Real schlickWeight(Real cosine) {
    const Real m = 1 - cosine;
    const Real m2 = m * m;
    return m2 * m2 * m;
}

/// F0 + (1 - F0) (1 - cosine)^5.
template <class Real>
[[nodiscard]] Vec3<Real> schlickFresnel(Real cosine, const Vec3<Real>& f0) {
    return f0 + (Real(1) - f0) * schlickWeight(cosine);
}

/// Unpolarised reflectance of a boundary to a medium of relative index eta; 1 where all is reflected.
/// `cosine` in [0, 1] on the side of arrival. [Walter 07, eq. 22]
template <class Real>
[[nodiscard]] Real dielectricFresnel(Real cosine, Real eta) {
    const Real g2 = eta * eta - 1 + cosine * cosine;
    if (g2 < 0) return 1;
    const Real g = std::sqrt(g2), sum = g + cosine;
    if (sum <= 0) return 1;
    const Real ratio = (g - cosine) / sum, inPlane = (cosine * sum - 1) / (cosine * (g - cosine) + 1);
    return std::min(Real(1), ratio * ratio / 2 * (1 + inPlane * inPlane));
}

/// Unpolarised reflectance of a metal of index eta - i k, relative to the medium of arrival. [Born 99, sec. 14.2]
template <class Real>
[[nodiscard]] Real conductorFresnel(Real cosine, Real eta, Real k) {
    const Real cos2 = cosine * cosine, sin2 = std::max(Real(0), 1 - cos2);
    const Real t = eta * eta - k * k - sin2;
    const Real sumOfSquares = std::sqrt(t * t + 4 * eta * eta * k * k);  // a^2 + b^2, a - i b the root of m^2 - sin^2
    const Real a = std::sqrt(std::max(Real(0), (sumOfSquares + t) / 2));
    const Real across = (sumOfSquares + cos2 - 2 * a * cosine) / (sumOfSquares + cos2 + 2 * a * cosine);
    const Real even = cos2 * sumOfSquares + sin2 * sin2, odd = 2 * a * cosine * sin2;
    return across * (1 + (even - odd) / (even + odd)) / 2;
}

template <class Real>
[[nodiscard]] Vec3<Real> conductorFresnel(Real cosine, const Vec3<Real>& eta, const Vec3<Real>& k) {
    return {conductorFresnel(cosine, eta.x, k.x), conductorFresnel(cosine, eta.y, k.y),
            conductorFresnel(cosine, eta.z, k.z)};
}

/// The mirror direction of w about m; all point away from the surface.
template <class Real>
[[nodiscard]] Vec3<Real> reflectAbout(const Vec3<Real>& w, const Vec3<Real>& m) {
    return 2 * glm::dot(w, m) * m - w;
}

/// Where light from w goes on beyond a facet of normal m, dot(w, m) > 0, into relative index eta. [Walter 07, eq. 40]
/// Not to be called where all is reflected.
template <class Real>
[[nodiscard]] Vec3<Real> refractThrough(const Vec3<Real>& w, const Vec3<Real>& m, Real eta) {
    const Real c = glm::dot(w, m);
    const Real cosT = std::sqrt(std::max(Real(0), 1 - (1 - c * c) / (eta * eta)));
    return glm::normalize((c / eta - cosT) * m - w / eta);
}

}  // namespace vkpt::reference
