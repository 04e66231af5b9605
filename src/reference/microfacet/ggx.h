// The GGX microfacet distribution with Smith's masking. Local frame, normal +z. [Walter 07], [Heitz 14]
#pragma once
#include <algorithm>

#include "reference/angle.h"

namespace vkpt::reference {

/// Density of microfacet normals. [Heitz 14, eq. 85] written without tan, so that nothing cancels at small alpha.
template <class Real>
[[nodiscard]] Real ggxD(const Vec3<Real>& wm, Real alphaX, Real alphaY) {
    const Real a2 = alphaX * alphaY, stretch = alphaY / alphaX;
    const Real d = a2 * wm.z * wm.z + stretch * wm.x * wm.x + wm.y * wm.y / stretch;
    return a2 / (kPiOf<Real> * d * d);
}

template <class Real>
[[nodiscard]] Real ggxD(const Vec3<Real>& wm, Real alpha) {
    return ggxD(wm, alpha, alpha);
}

/// Smith's Lambda of a = |cot theta| / alpha towards the direction; a may be infinite. [Heitz 14, eq. 72]
template <class Real>
[[nodiscard]] Real ggxLambda(Real a) {
    return (std::sqrt(1 + 1 / (a * a)) - 1) / 2;
}

/// sqrt(a^2 + (1 - a^2) cos^2): the root in both of Smith's functions.
template <class Real>
[[nodiscard]] Real smithRoot(Real cosine, Real alpha) {
    const Real a2 = alpha * alpha;
    return std::sqrt(a2 + (1 - a2) * cosine * cosine);
}

/// Masking of one direction. [Heitz 14, eqs. 43 and 72]
template <class Real>
[[nodiscard]] Real ggxG1(Real cosine, Real alpha) {
    return 2 * cosine / (cosine + smithRoot(cosine, alpha));
}

/// V = G2 / (4 cosO cosI), height-correlated. [Heitz 14, eq. 99]
template <class Real>
[[nodiscard]] Real ggxVisibility(Real cosO, Real cosI, Real alpha) {
    return Real(0.5) / (cosI * smithRoot(cosO, alpha) + cosO * smithRoot(cosI, alpha));
}

/// Density of the normals visible from wo. [Heitz 18, eq. 3]
template <class Real>
[[nodiscard]] Real ggxVisibleNormalPdf(const Vec3<Real>& wo, const Vec3<Real>& wm, Real alpha) {
    return ggxG1(wo.z, alpha) * std::max(Real(0), glm::dot(wo, wm)) * ggxD(wm, alpha) / wo.z;
}

/// A normal visible from wo (wo.z > 0), by spherical caps. [Dupuy 23, listings 1 and 3]
template <class Real>
[[nodiscard]] Vec3<Real> sampleGgxVisibleNormal(const Vec3<Real>& wo, Real alphaX, Real alphaY, const Vec2<Real>& u) {
    const Vec3<Real> woStd = glm::normalize(Vec3<Real>(alphaX * wo.x, alphaY * wo.y, wo.z));
    const Real z = (1 - u.y) * (1 + woStd.z) - woStd.z;
    const Real sinTheta = std::sqrt(std::max(Real(0), (1 - z) * (1 + z)));
    const Vec3<Real> cap(sinTheta * cosSinTurns(u.x), z);
    const Vec3<Real> wmStd = cap + woStd;
    return glm::normalize(Vec3<Real>(alphaX * wmStd.x, alphaY * wmStd.y, wmStd.z));
}

template <class Real>
[[nodiscard]] Vec3<Real> sampleGgxVisibleNormal(const Vec3<Real>& wo, Real alpha, const Vec2<Real>& u) {
    return sampleGgxVisibleNormal(wo, alpha, alpha, u);
}

/// A normal with density D cos. [Walter 07, eqs. 35 and 36]
template <class Real>
[[nodiscard]] Vec3<Real> sampleGgxNormal(Real alphaX, Real alphaY, const Vec2<Real>& u) {
    const Vec2<Real> slope = std::sqrt(u.y / (1 - u.y)) * cosSinTurns(u.x);
    return glm::normalize(Vec3<Real>(alphaX * slope.x, alphaY * slope.y, 1));
}

}  // namespace vkpt::reference
