// What light gains that facets reflect more than once: reciprocal lobes that make good for the energy a model of single
// scattering loses. [Kulla 17] estimator.md, Interreflection.
#pragma once
#include "reference/bsdf/model.h"

namespace vkpt::reference {

/// 1 - E towards w: what single scattering loses where facets lose nothing.
template <class Real>
[[nodiscard]] Real lostEnergy(const Bsdf<Real>& b, const AlbedoTable& table, const Vec3<Real>& w) {
    return table.albedo(albedoPlace(b, w)).lost;
}

/// The mean of lostEnergy.
template <class Real>
[[nodiscard]] Real lostEnergyMean(const Bsdf<Real>& b, const AlbedoTable& table) {
    return albedoMean(b, table).lost;
}

/// (1 - E(wo)) (1 - E(wi)) / (pi (1 - mean)): the shape of the lobe; 0 where nothing is lost.
template <class Real>
[[nodiscard]] Real lostEnergyLobe(Real lostO, Real lostI, Real mean) {
    return mean > 0 ? lostO * lostI / (kPiOf<Real> * mean) : Real(0);
}

/// c = alpha^2 of the lobe's directions: facets lose most light at cosines of about alpha.
template <class Real>
[[nodiscard]] Real lobeSpread(const Bsdf<Real>& b) {
    const Real alpha = meanAlpha(b);
    return alpha * alpha;
}

/// A direction for the lobe, wi.z > 0: cos^2 is log-uniform from about c on.
template <class Real>
[[nodiscard]] Vec3<Real> sampleLostEnergyLobe(const Bsdf<Real>& b, const Vec2<Real>& u) {
    const Real c = lobeSpread(b);
    const Real cos2 = std::min(Real(1), c * std::expm1(u.y * std::log1p(1 / c)));
    return {std::sqrt(1 - cos2) * cosSinTurns(u.x), std::sqrt(cos2)};
}

/// Density of sampleLostEnergyLobe, on either side.
template <class Real>
[[nodiscard]] Real lostEnergyLobePdf(const Bsdf<Real>& b, const Vec3<Real>& wi) {
    const Real c = lobeSpread(b);
    return std::abs(wi.z) / (kPiOf<Real> * (wi.z * wi.z + c) * std::log1p(1 / c));
}

/// Share of the lost energy that facets of mean reflectance F give back, `lost` the mean of what is lost where F is 1.
/// [Kulla 17], as a geometric series of the energy that stays between facets.
template <class Real>
[[nodiscard]] Vec3<Real> returnedShare(const Vec3<Real>& f, Real lost) {
    return f * f * (1 - lost) / (Real(1) - f * lost);
}

}  // namespace vkpt::reference
