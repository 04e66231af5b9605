// The Phong microfacet distribution, with the anisotropy of [Ashikhmin 00]. Local frame, normal +z. [Walter 07]
#pragma once
#include "reference/angle.h"

namespace vkpt::reference {

/// Exponent of the distribution as rough as Beckmann's of alpha. [Walter 07, sec. 5.2]
template <class Real>
[[nodiscard]] Real phongExponent(Real alpha) {
    return 2 / (alpha * alpha) - 2;
}

/// cos^exponent of a unit vector at the square of its sine: 1 - cos loses its digits where exponents are large.
template <class Real>
[[nodiscard]] Real powerOfCosine(Real cosine, Real sine2, Real exponent) {
    return sine2 < Real(0.5) ? std::exp(exponent / 2 * std::log1p(-sine2)) : std::pow(cosine, exponent);
}

/// Exponents along x and y, blended over the azimuth: eX cos^2 + eY sin^2. [Ashikhmin 00, eq. 4]
template <class Real>
[[nodiscard]] Real exponentTowards(const Vec3<Real>& wm, Real exponentX, Real exponentY) {
    const Real sine2 = wm.x * wm.x + wm.y * wm.y;
    return sine2 > 0 ? (exponentX * wm.x * wm.x + exponentY * wm.y * wm.y) / sine2 : exponentX;
}

/// wm.z^e(phi), the shape of anisotropic cosine lobes.
template <class Real>
[[nodiscard]] Real cosineLobe(const Vec3<Real>& wm, Real exponentX, Real exponentY) {
    return powerOfCosine(wm.z, wm.x * wm.x + wm.y * wm.y, exponentTowards(wm, exponentX, exponentY));
}

/// A normal with density sqrt((eX + 1) (eY + 1)) / (2 pi) wm.z^e(phi). [Ashikhmin 00, eqs. 9 and 10]
template <class Real>
[[nodiscard]] Vec3<Real> sampleCosineLobe(Real exponentX, Real exponentY, const Vec2<Real>& u) {
    Vec2<Real> phi = cosSinTurns(u.x);
    phi.y *= std::sqrt((exponentX + 1) / (exponentY + 1));
    phi = glm::normalize(phi);
    const Real e = exponentX * phi.x * phi.x + exponentY * phi.y * phi.y;
    const Real logCos = std::log1p(-u.y) / (e + 1);
    const Real sinTheta = std::sqrt(-std::expm1(2 * logCos));
    return {sinTheta * phi, std::exp(logCos)};
}

/// Density of microfacet normals: D cos integrates to 1. [Walter 07, eq. 30]
template <class Real>
[[nodiscard]] Real phongD(const Vec3<Real>& wm, Real alphaX, Real alphaY) {
    const Real ex = phongExponent(alphaX), ey = phongExponent(alphaY);
    return std::sqrt((ex + 2) * (ey + 2)) / (2 * kPiOf<Real>)*cosineLobe(wm, ex, ey);
}

/// A normal with density D cos. [Walter 07, eqs. 31 and 32]
template <class Real>
[[nodiscard]] Vec3<Real> samplePhongNormal(Real alphaX, Real alphaY, const Vec2<Real>& u) {
    return sampleCosineLobe(phongExponent(alphaX) + 1, phongExponent(alphaY) + 1, u);
}

}  // namespace vkpt::reference
