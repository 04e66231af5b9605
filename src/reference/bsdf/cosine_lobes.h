// What phong and blinn_phong share: the choice between a cosine lobe and the diffuse part, and directions in the lobe.
#pragma once
#include "reference/bsdf/model.h"
#include "reference/microfacet/phong.h"

namespace vkpt::reference {

/// Probability of the cosine lobe.
template <class Real>
[[nodiscard]] Real cosineLobeShare(const Bsdf<Real>& b) {
    return shareOf(luminance(b.color), luminance(b.diffuse));
}

/// A direction about +z with density (e + 1) / (2 pi) cos^e.
template <class Real>
[[nodiscard]] Vec3<Real> sampleRoundLobe(Real exponent, const Vec2<Real>& u) {
    const Real logCos = std::log1p(-u.y) / (exponent + 1);
    return {std::sqrt(-std::expm1(2 * logCos)) * cosSinTurns(u.x), std::exp(logCos)};
}

}  // namespace vkpt::reference
