// Glass, smooth or rough: facets that reflect and transmit [Walter 07, eqs. 20 and 21], visible normals, radiance
// divided by eta^2 where it crosses, and interreflection on both sides [Kulla 17].
#include "reference/bsdf.h"
#include "reference/bsdf/compensation.h"

namespace vkpt::reference {

namespace {

/// No lobe has a density: smooth, or a boundary between equal media.
template <class Real>
bool isSmooth(const Bsdf<Real>& b) {
    return b.isDelta() || b.eta.x == 1;
}

/// The facet that sends wo through to wi, and the Jacobian of its half vector per solid angle of wi.
template <class Real>
struct TransmittingFacet {
    Vec3<Real> wm;
    Real cosO, cosI;  ///< |wo . wm|, |wi . wm|
    Real jacobian;    ///< cosI / (wi . wm + wo . wm / eta)^2 [Walter 07, eq. 17]
    bool exists;

    TransmittingFacet(const Vec3<Real>& wo, const Vec3<Real>& wi, Real eta) : wm(glm::normalize(wo + eta * wi)) {
        if (wm.z < 0) wm = -wm;
        const Real o = glm::dot(wo, wm), i = glm::dot(wi, wm), sum = i + o / eta;
        cosO = o;
        cosI = -i;
        jacobian = cosI / (sum * sum);
        exists = o > 0 && i < 0 && wm.z > 0;
    }
};

/// Choice of the lobe that makes good for what facets lose: how probable it is, and how much of it goes through.
template <class Real>
struct LostLobe {
    Real probability = 0;  ///< 1 - E(wo), at most 9/10: few draws of facets would weigh much
    Real transmitted = 0;  ///< share

    LostLobe(const Bsdf<Real>& b, const Vec3<Real>& wo) {
        if (!b.compensates()) return;
        const auto near = GlassInterreflection<Real>::bothSides(b)[0];
        probability = std::min(near.lost(wo), Real(0.9));
        transmitted = near.transmitted(wo);
    }
};

template <class Real>
Vec3<Real> evalLost(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (!b.compensates()) return Vec3<Real>(0);
    const auto [near, far] = GlassInterreflection<Real>::bothSides(b);
    if (wi.z > 0) {
        const auto reflected = [&](const Vec3<Real>& w) { return near.lost(w) * (1 - near.transmitted(w)); };
        return Vec3<Real>(lostEnergyLobe(reflected(wo), reflected(wi), near.reflectedMean()));
    }
    const Real in = near.lost(wo) * near.transmitted(wo), out = far.lost(wi) * far.transmitted(wi);
    return b.color * (lostEnergyLobe(in, out, far.transmittedMean()) / (b.eta.x * b.eta.x));
}

template <class Real>
Vec3<Real> evalFacets(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    const Real eta = b.eta.x;
    if (wi.z > 0) {
        const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
        return Vec3<Real>(dielectricFresnel(cosine, eta) * facetReflection(b.facets(), wo, wi));
    }
    const TransmittingFacet<Real> facet(wo, wi, eta);
    if (!facet.exists) return Vec3<Real>(0);
    const Facets<Real> facets = b.facets();
    const Real through = (1 - dielectricFresnel(facet.cosO, eta)) * facetD(facets, facet.wm) *
                         maskingG2(facets, wo, wi, facet.wm) * facet.cosO * facet.jacobian / (wo.z * -wi.z);
    return b.color * (through / (eta * eta));
}

template <class Real>
Real facetsPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z > 0) {
        const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
        return dielectricFresnel(cosine, b.eta.x) * facetReflectionPdf(b.facets(), wo, wi);
    }
    const TransmittingFacet<Real> facet(wo, wi, b.eta.x);
    if (!facet.exists) return 0;
    return (1 - dielectricFresnel(facet.cosO, b.eta.x)) * visibleFacetPdf(b.facets(), wo, facet.wm) * facet.jacobian;
}

/// A direction that a boundary of normal wm sends wo to; nothing where it lies on the wrong side of the surface.
template <class Real>
BsdfSample<Real> crossOrReflect(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wm, Real uLobe) {
    const Real cosine = glm::dot(wo, wm);
    if (cosine <= 0) return {};
    const bool reflects = choose(uLobe, dielectricFresnel(cosine, b.eta.x));
    const Vec3<Real> wi = reflects ? reflectAbout(wo, wm) : refractThrough(wo, wm, b.eta.x);
    if (reflects ? wi.z <= 0 : wi.z >= 0) return {};
    return towards(wi);
}

}  // namespace

template <class Real>
Vec3<Real> dielectricEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (isSmooth(b) || wi.z == 0) return Vec3<Real>(0);
    return evalFacets(b, wo, wi) + evalLost(b, wo, wi);
}

template <class Real>
Real dielectricPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (isSmooth(b) || wi.z == 0) return 0;
    const LostLobe<Real> between(b, wo);
    const Real facets = (1 - between.probability) * facetsPdf(b, wo, wi);
    if (!(between.probability > 0)) return facets;
    const Real share = wi.z > 0 ? 1 - between.transmitted : between.transmitted;
    return facets + between.probability * share * lostEnergyLobePdf(b, wi);
}

template <class Real>
BsdfSample<Real> dielectricSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    const Real eta = b.eta.x;
    if (isSmooth(b)) {
        const Vec3<Real> normal(0, 0, 1);
        if (choose(uLobe, dielectricFresnel(wo.z, eta))) return deltaSample(mirrored(wo), Vec3<Real>(1));
        return deltaSample(refractThrough(wo, normal, eta), b.color / (eta * eta));
    }
    const LostLobe<Real> between(b, wo);
    if (choose(uLobe, between.probability)) {
        Vec3<Real> wi = sampleLostEnergyLobe(b, u);
        if (choose(uLobe, between.transmitted)) wi.z = -wi.z;
        return towards(wi);
    }
    return crossOrReflect(b, wo, sampleVisibleFacet(b.facets(), wo, u, uLobe), uLobe);
}

template <class Real>
bool dielectricHasDensity(const Bsdf<Real>& b, const Vec3<Real>&) {
    return !isSmooth(b);
}

VKPT_INSTANTIATE_BSDF(dielectric)

}  // namespace vkpt::reference
