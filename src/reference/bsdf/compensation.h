// What light gains that facets reflect more than once: reciprocal lobes that make good for the energy a model of single
// scattering loses. [Kulla 17] estimator.md, Interreflection.
#pragma once
#include "reference/bsdf/model.h"

namespace vkpt::reference {

/// E = first + second towards w, at most 1: what single scattering keeps where facets lose nothing.
template <class Real>
[[nodiscard]] Real keptEnergy(const Bsdf<Real>& b, const AlbedoTable& table, const Vec3<Real>& w) {
    const Vec2<Real> a = table.albedo(w.z, albedoRow(b, w));
    return std::min(Real(1), a.x + a.y);
}

/// The mean of keptEnergy.
template <class Real>
[[nodiscard]] Real keptEnergyMean(const Bsdf<Real>& b, const AlbedoTable& table, const Vec3<Real>& w) {
    const Vec2<Real> a = table.mean(albedoRow(b, w));
    return std::min(Real(1), a.x + a.y);
}

/// (1 - E(wo)) (1 - E(wi)) / (pi (1 - mean)): the shape of the lobe; 0 where nothing is lost.
template <class Real>
[[nodiscard]] Real lostEnergyLobe(Real keptO, Real keptI, Real mean) {
    return mean < 1 ? (1 - keptO) * (1 - keptI) / (kPiOf<Real> * (1 - mean)) : Real(0);
}

/// Share of the lost energy that facets of mean reflectance F give back. [Kulla 17], as a geometric series of the
/// energy that stays between facets.
template <class Real>
[[nodiscard]] Vec3<Real> returnedShare(const Vec3<Real>& f, Real mean) {
    return f * f * mean / (Real(1) - f * (1 - mean));
}

}  // namespace vkpt::reference
