// What light gains that facets reflect more than once: reciprocal lobes that make good for the energy a model of single
// scattering loses. [Kulla 17] estimator.md, Interreflection.
#pragma once
#include <array>

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

/// Share of the lost energy that facets of mean reflectance F give back, where `lost` of what a further facet reflects
/// does not leave. [Kulla 17], as a geometric series of the energy that stays between facets.
template <class Real>
[[nodiscard]] Vec3<Real> returnedShare(const Vec3<Real>& f, Real lost) {
    return f * f * (1 - lost) / (Real(1) - f * lost);
}

/// What metal facets give back of the light that more than one of them meets.
template <class Real>
class MetalInterreflection {
public:
    explicit MetalInterreflection(const Bsdf<Real>& b) : b_(b) {
        const MetalWalk<Real> walk = b.table.metalWalk(albedoRow(meanAlpha(b)));
        const auto share = [&](int i) {
            return returnedShare(b.color * facetFresnel(b, walk.cosine[i]), 1 - walk.escape[i]);
        };
        along_ = share(0);
        grazing_ = share(1);
        mean_ = lostEnergyMean(b, b.table) * glm::mix(along_, grazing_, walk.place);
    }

    /// Of light towards w.
    [[nodiscard]] Vec3<Real> albedo(const Vec3<Real>& w) const {
        const Real steep = 1 - std::abs(w.z);
        return lostEnergy(b_, b_.table, w) * glm::mix(along_, grazing_, steep * steep);
    }

    /// f, whose albedos these are.
    [[nodiscard]] Vec3<Real> eval(const Vec3<Real>& wo, const Vec3<Real>& wi) const {
        const Vec3<Real> o = albedo(wo), i = albedo(wi);
        Vec3<Real> f;
        for (int c = 0; c < 3; ++c) f[c] = lostEnergyLobe(o[c], i[c], mean_[c]);
        return f;
    }

private:
    const Bsdf<Real>& b_;
    Vec3<Real> along_, grazing_, mean_;
};

/// The same of glass, from one side.
template <class Real>
class GlassInterreflection {
public:
    /// The side of wo, and the other.
    [[nodiscard]] static std::array<GlassInterreflection, 2> bothSides(const Bsdf<Real>& b) {
        const bool front = b.eta.x > 1;
        GlassInterreflection near(b, b.table), far(b, b.farTable);
        GlassInterreflection &outside = front ? near : far, &inside = front ? far : near;
        const Real eta = front ? b.eta.x : 1 / b.eta.x;
        // The flux that crosses is the same both ways, but for eta^2: no more than the lesser of both can give.
        const Real flux = std::min(outside.walk_.share * outside.lost_, eta * eta * inside.lost_);
        outside.cross(flux);
        inside.cross(flux / (eta * eta));
        return {near, far};
    }

    /// Of light towards w, on this side: all that more than one facet meets, and its share that is transmitted.
    [[nodiscard]] Real lost(const Vec3<Real>& w) const { return lostEnergy(b_, table_, w); }
    [[nodiscard]] Real transmitted(const Vec3<Real>& w) const {
        const Real cosine = std::abs(w.z);
        const Real share = share_ * (1 + slope_ * (cosine * cosine * (2 - cosine) - walk_.place));
        return std::clamp(share, Real(0), Real(1));  // it may lie outside by rounding
    }
    /// Means over this side.
    [[nodiscard]] Real transmittedMean() const { return lost_ * share_; }
    [[nodiscard]] Real reflectedMean() const { return lost_ * (1 - share_); }

private:
    GlassInterreflection(const Bsdf<Real>& b, const AlbedoTable& table)
        : b_(b), table_(table), walk_(table.glassWalk(albedoRow(meanAlpha(b)))), lost_(lostEnergyMean(b, table)) {}

    /// The slope is limited so that shares stay within 0 and 1.
    void cross(Real flux) {
        share_ = lost_ > 0 ? std::min(Real(1), flux / lost_) : Real(0);
        const Real below = std::max(walk_.place, Real(1e-6)), above = 1 - walk_.place;
        const Real rest = share_ > 0 ? (1 - share_) / share_ : Real(0);
        slope_ = std::clamp(walk_.slope, -std::min(1 / above, rest / below), std::min(1 / below, rest / above));
    }

    const Bsdf<Real>& b_;
    const AlbedoTable& table_;
    GlassWalk<Real> walk_;
    Real lost_, share_ = 0, slope_ = 0;
};

}  // namespace vkpt::reference
