// A diffuse base under a dielectric coat, smooth or rough, between which light goes back and forth. Couples both as
// [Kelemen 01] and [Ashikhmin 00] do, with the internal reflectance of [Egan 73].
#include "reference/bsdf.h"

namespace vkpt::reference {

namespace {

/// What enters the coat towards w, and its mean.
template <class Real>
Real entered(const Bsdf<Real>& b, const Vec3<Real>& w) {
    if (b.isDelta()) return 1 - dielectricFresnel(w.z, b.eta.x);
    const Albedo<Real> albedo = b.table.albedo(albedoPlace(b, w));
    return albedo.second + albedo.lost;
}

template <class Real>
Real enteredMean(const Bsdf<Real>& b) {
    if (b.isDelta()) return 1 - b.average.x;
    const Albedo<Real> mean = albedoMean(b, b.table);
    return mean.second + mean.lost;
}

template <class Real>
Real coatShare(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    const Real in = entered(b, wo);
    return shareOf(1 - in, in * luminance(b.diffuse));
}

/// The base seen through the coat; light that the coat turns back inside is reflected again.
template <class Real>
Vec3<Real> evalBase(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    const Real eta2 = b.eta.x * b.eta.x;
    const Real turnedBack = 1 - enteredMean(b) / eta2;
    return entered(b, wo) * entered(b, wi) * b.diffuse / (kPiOf<Real> * eta2 * (Real(1) - b.diffuse * turnedBack));
}

}  // namespace

template <class Real>
Vec3<Real> plasticEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Vec3<Real> base = evalBase(b, wo, wi);
    if (b.isDelta()) return base;
    const Real cosine = glm::dot(wo, glm::normalize(wo + wi));
    return base + dielectricFresnel(cosine, b.eta.x) * facetReflection(b.facets(), wo, wi);
}

template <class Real>
Real plasticPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Real p = coatShare(b, wo), base = (1 - p) * cosinePdf(wi);
    return b.isDelta() ? base : base + p * facetReflectionPdf(b.facets(), wo, wi);
}

template <class Real>
BsdfSample<Real> plasticSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    const Real p = coatShare(b, wo);
    if (!choose(uLobe, p)) return towards(squareToCosineHemisphere(u));
    if (b.isDelta()) return deltaSample(mirrored(wo), Vec3<Real>(dielectricFresnel(wo.z, b.eta.x) / p));
    return towards(reflectAbout(wo, sampleVisibleFacet(b.facets(), wo, u, uLobe)));
}

template <class Real>
bool plasticHasDensity(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    return !b.isDelta() || coatShare(b, wo) < 1;
}

VKPT_INSTANTIATE_BSDF(plastic)

}  // namespace vkpt::reference
