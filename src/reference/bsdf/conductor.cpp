// Metal, smooth or rough: mirror facets [Walter 07, eq. 20] with visible normals, and interreflection [Kulla 17].
#include "reference/bsdf.h"
#include "reference/bsdf/compensation.h"

namespace vkpt::reference {

namespace {

/// Probability of the facets against the lobe of interreflection.
template <class Real>
Real facetShare(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    if (!b.compensates()) return 1;
    const Real single = luminance(b.color * facetFresnel(b, wo.z)) * (1 - lostEnergy(b, b.table, wo));
    return shareOf(single, luminance(MetalInterreflection<Real>(b).albedo(wo)));
}

}  // namespace

template <class Real>
Vec3<Real> conductorEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (b.isDelta() || wi.z <= 0) return Vec3<Real>(0);
    const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
    Vec3<Real> f = b.color * facetFresnel(b, cosine) * facetReflection(b.facets(), wo, wi);
    if (b.compensates()) f += MetalInterreflection<Real>(b).eval(wo, wi);
    return f;
}

template <class Real>
Real conductorPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (b.isDelta() || wi.z <= 0) return 0;
    const Real p = facetShare(b, wo);
    return p * facetReflectionPdf(b.facets(), wo, wi) + (p < 1 ? (1 - p) * lostEnergyLobePdf(b, wi) : Real(0));
}

template <class Real>
BsdfSample<Real> conductorSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (b.isDelta()) return deltaSample(mirrored(wo), b.color * facetFresnel(b, wo.z));
    if (!choose(uLobe, facetShare(b, wo))) return towards(sampleLostEnergyLobe(b, u));
    return towards(reflectAbout(wo, sampleVisibleFacet(b.facets(), wo, u, uLobe)));
}

template <class Real>
bool conductorHasDensity(const Bsdf<Real>& b, const Vec3<Real>&) {
    return !b.isDelta();
}

VKPT_INSTANTIATE_BSDF(conductor)

}  // namespace vkpt::reference
