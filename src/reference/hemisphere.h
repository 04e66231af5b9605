// Directions around the normal that are drawn without regard to any BSDF. estimator.md, Options.
#pragma once
#include "constants.h"
#include "reference/warp.h"

namespace vkpt::reference {

/// Direction around +z with density 1/(2 pi): on a sphere the height is uniform.
template <class Real>
[[nodiscard]] Vec3<Real> squareToUniformHemisphere(const Vec2<Real>& u) {
    const Real z = u.y, sine = std::sqrt(std::max(Real(0), 1 - z * z));
    return {sine * cosSinTurns(u.x), z};
}

/// `kind`: kHemisphereUniform, else weighted by the cosine.
template <class Real>
[[nodiscard]] Vec3<Real> sampleHemisphere(std::uint32_t kind, const Vec2<Real>& u) {
    return kind == kHemisphereUniform ? squareToUniformHemisphere(u) : squareToCosineHemisphere(u);
}

/// Density of sampleHemisphere per solid angle; 0 below the surface.
template <class Real>
[[nodiscard]] Real hemispherePdf(std::uint32_t kind, const Vec3<Real>& wi) {
    if (wi.z < 0) return 0;
    return kind == kHemisphereUniform ? 1 / (2 * kPiOf<Real>) : wi.z / kPiOf<Real>;
}

}  // namespace vkpt::reference
