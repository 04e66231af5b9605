// Mirror facets in V-grooves. [Torrance 67]
#include "reference/bsdf.h"

namespace vkpt::reference {

namespace {

template <class Real>
Facets<Real> groovesOf(const Bsdf<Real>& b) {
    Facets<Real> facets = b.facets();
    facets.masking = kMaskingVGroove;
    return facets;
}

}  // namespace

template <class Real>
Vec3<Real> torranceSparrowEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (b.isDelta() || wi.z <= 0) return Vec3<Real>(0);
    const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
    return b.color * facetFresnel(b, cosine) * facetReflection(groovesOf(b), wo, wi);
}

template <class Real>
Real torranceSparrowPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    return b.isDelta() ? Real(0) : facetReflectionPdf(groovesOf(b), wo, wi);
}

template <class Real>
BsdfSample<Real> torranceSparrowSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (b.isDelta()) return deltaSample(mirrored(wo), b.color * facetFresnel(b, wo.z));
    return towards(reflectAbout(wo, sampleVisibleFacet(groovesOf(b), wo, u, uLobe)));
}

template <class Real>
bool torranceSparrowHasDensity(const Bsdf<Real>& b, const Vec3<Real>&) {
    return !b.isDelta();
}

VKPT_INSTANTIATE_BSDF(torranceSparrow)

}  // namespace vkpt::reference
