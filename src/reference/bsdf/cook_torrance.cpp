// Facets in V-grooves of two roughnesses, weighted, over a diffuse part. [Cook 81], with the factor 4 of
// [Walter 07] in place of the paper's pi.
#include "reference/bsdf.h"

namespace vkpt::reference {

namespace {

template <class Real>
Facets<Real> groovesOf(const Bsdf<Real>& b, Real alpha) {
    const Real a = std::max(alpha, Real(kDeltaAlpha));
    return {a, a, b.flags & kBsdfDistributionMask, kMaskingVGroove};
}

/// Probability of the facets against the diffuse part.
template <class Real>
Real lobeShare(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    return shareOf(b.specular * luminance(b.color * facetFresnel(b, wo.z)), (1 - b.specular) * luminance(b.diffuse));
}

}  // namespace

template <class Real>
Vec3<Real> cookTorranceEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
    const Real facets = b.weight * facetReflection(groovesOf(b, b.alphaX), wo, wi) +
                        (1 - b.weight) * facetReflection(groovesOf(b, b.alphaY), wo, wi);
    return (1 - b.specular) * b.diffuse / kPiOf<Real> + b.color * facetFresnel(b, cosine) * (b.specular * facets);
}

template <class Real>
Real cookTorrancePdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Real p = lobeShare(b, wo);
    const Real facets = b.weight * facetReflectionPdf(groovesOf(b, b.alphaX), wo, wi) +
                        (1 - b.weight) * facetReflectionPdf(groovesOf(b, b.alphaY), wo, wi);
    return p * facets + (1 - p) * cosinePdf(wi);
}

template <class Real>
BsdfSample<Real> cookTorranceSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (!choose(uLobe, lobeShare(b, wo))) return towards(squareToCosineHemisphere(u));
    const Real alpha = choose(uLobe, b.weight) ? b.alphaX : b.alphaY;
    return towards(reflectAbout(wo, sampleVisibleFacet(groovesOf(b, alpha), wo, u, uLobe)));
}

template <class Real>
bool cookTorranceHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return true;
}

VKPT_INSTANTIATE_BSDF(cookTorrance)

}  // namespace vkpt::reference
