#include "reference/microfacet/facets.h"

#include "reference/microfacet/beckmann.h"
#include "reference/microfacet/ggx.h"
#include "reference/microfacet/phong.h"

namespace vkpt::reference {

namespace {

/// Facets are sampled by D cos, whoever sees them.
template <class Real>
bool ignoresVisibility(const Facets<Real>& f) {
    return f.distribution == kDistributionPhong && f.masking != kMaskingVGroove;
}

/// Masking of a facet by the other side of its groove. [Torrance 67], [Cook 81]
template <class Real>
Real grooveG1(const Vec3<Real>& w, const Vec3<Real>& wm) {
    return std::min(Real(1), 2 * wm.z * std::abs(w.z) / std::abs(glm::dot(w, wm)));
}

/// Euler's. In double: the logarithms are large and their sum is not.
double betaFunction(double x, double y) {
    int sign = 0;
    return std::exp(lgamma_r(x, &sign) + lgamma_r(y, &sign) - lgamma_r(x + y, &sign));
}

}  // namespace

template <class Real>
Real facetD(const Facets<Real>& f, const Vec3<Real>& wm) {
    if (wm.z <= 0) return 0;
    if (f.distribution == kDistributionGgx) return ggxD(wm, f.alphaX, f.alphaY);
    if (f.distribution == kDistributionBeckmann) return beckmannD(wm, f.alphaX, f.alphaY);
    return phongD(wm, f.alphaX, f.alphaY);
}

template <class Real>
Real smithLambda(const Facets<Real>& f, const Vec3<Real>& w) {
    const Vec2<Real> stretched(f.alphaX * w.x, f.alphaY * w.y);
    const Real a = std::abs(w.z) / std::sqrt(glm::dot(stretched, stretched));
    return f.distribution == kDistributionGgx ? ggxLambda(a) : beckmannLambda(a);
}

template <class Real>
Real maskingG1(const Facets<Real>& f, const Vec3<Real>& w, const Vec3<Real>& wm) {
    return f.masking == kMaskingVGroove ? grooveG1(w, wm) : 1 / (1 + smithLambda(f, w));
}

template <class Real>
Real maskingG2(const Facets<Real>& f, const Vec3<Real>& wo, const Vec3<Real>& wi, const Vec3<Real>& wm) {
    if (f.masking == kMaskingVGroove) return std::min(grooveG1(wo, wm), grooveG1(wi, wm));
    if (f.masking == kMaskingSeparable) return 1 / ((1 + smithLambda(f, wo)) * (1 + smithLambda(f, wi)));
    const Real o = smithLambda(f, wo), i = smithLambda(f, wi);
    return wo.z * wi.z < 0 ? static_cast<Real>(betaFunction(1 + o, 1 + i)) : 1 / (1 + o + i);
}

template <class Real>
Vec3<Real> sampleFacet(const Facets<Real>& f, const Vec2<Real>& u) {
    if (f.distribution == kDistributionGgx) return sampleGgxNormal(f.alphaX, f.alphaY, u);
    if (f.distribution == kDistributionBeckmann) return sampleBeckmannNormal(f.alphaX, f.alphaY, u);
    return samplePhongNormal(f.alphaX, f.alphaY, u);
}

template <class Real>
Vec3<Real> sampleVisibleFacet(const Facets<Real>& f, const Vec3<Real>& wo, const Vec2<Real>& u, Real& uLobe) {
    if (f.masking == kMaskingVGroove) {  // [Heitz 14b, sec. 4.1]
        const Vec3<Real> wm = sampleFacet(f, u), other(-wm.x, -wm.y, wm.z);
        const Real seen = std::max(Real(0), glm::dot(wo, wm)), otherSeen = std::max(Real(0), glm::dot(wo, other));
        return choose(uLobe, seen / (seen + otherSeen)) ? wm : other;
    }
    if (ignoresVisibility(f)) return sampleFacet(f, u);
    if (f.distribution == kDistributionGgx) return sampleGgxVisibleNormal(wo, f.alphaX, f.alphaY, u);
    return sampleBeckmannVisibleNormal(wo, f.alphaX, f.alphaY, u);
}

template <class Real>
Real visibleFacetPdf(const Facets<Real>& f, const Vec3<Real>& wo, const Vec3<Real>& wm) {
    const Real cosine = glm::dot(wo, wm);
    if (cosine <= 0) return 0;
    if (ignoresVisibility(f)) return facetD(f, wm) * wm.z;
    return facetD(f, wm) * maskingG1(f, wo, wm) * cosine / wo.z;
}

template <class Real>
Real facetReflection(const Facets<Real>& f, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    return facetD(f, wm) * maskingG2(f, wo, wi, wm) / (4 * wo.z * wi.z);
}

template <class Real>
Real facetReflectionPdf(const Facets<Real>& f, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    return visibleFacetPdf(f, wo, wm) / (4 * glm::dot(wo, wm));
}

#define VKPT_INSTANTIATE(Real)                                                                                \
    template Real facetD(const Facets<Real>&, const Vec3<Real>&);                                             \
    template Real smithLambda(const Facets<Real>&, const Vec3<Real>&);                                        \
    template Real maskingG1(const Facets<Real>&, const Vec3<Real>&, const Vec3<Real>&);                       \
    template Real maskingG2(const Facets<Real>&, const Vec3<Real>&, const Vec3<Real>&, const Vec3<Real>&);    \
    template Vec3<Real> sampleFacet(const Facets<Real>&, const Vec2<Real>&);                                  \
    template Vec3<Real> sampleVisibleFacet(const Facets<Real>&, const Vec3<Real>&, const Vec2<Real>&, Real&); \
    template Real visibleFacetPdf(const Facets<Real>&, const Vec3<Real>&, const Vec3<Real>&);                 \
    template Real facetReflection(const Facets<Real>&, const Vec3<Real>&, const Vec3<Real>&);                 \
    template Real facetReflectionPdf(const Facets<Real>&, const Vec3<Real>&, const Vec3<Real>&);
VKPT_INSTANTIATE(float)
VKPT_INSTANTIATE(double)
#undef VKPT_INSTANTIATE

}  // namespace vkpt::reference
