// An anisotropic cosine lobe with Schlick's Fresnel over a diffuse substrate that takes what it leaves. [Ashikhmin 00]
#include "reference/bsdf.h"
#include "reference/microfacet/phong.h"

namespace vkpt::reference {

namespace {

template <class Real>
Real lobeScale(const Bsdf<Real>& b) {
    return std::sqrt((b.exponentX + 1) * (b.exponentY + 1));
}

/// Eq. 5: 28 Rd (1 - Rs) / (23 pi) (1 - (1 - cosO / 2)^5) (1 - (1 - cosI / 2)^5).
template <class Real>
Vec3<Real> substrate(const Bsdf<Real>& b, Real cosO, Real cosI) {
    const Real entered = (1 - schlickWeight(cosO / 2)) * (1 - schlickWeight(cosI / 2));
    return b.diffuse * (Real(1) - b.color) * (28 / (23 * kPiOf<Real>)*entered);
}

template <class Real>
Real specularShare(const Bsdf<Real>& b, const Vec3<Real>& wo) {
    return shareOf(luminance(schlickFresnel(wo.z, b.color)), luminance((Real(1) - b.color) * b.diffuse));
}

}  // namespace

template <class Real>
Vec3<Real> ashikhminShirleyEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real cosine = glm::dot(wo, wm);
    const Real lobe = lobeScale(b) / (8 * kPiOf<Real>)*cosineLobe(wm, b.exponentX, b.exponentY) /
                      (cosine * std::max(wo.z, wi.z));  // eq. 4
    return schlickFresnel(cosine, b.color) * lobe + substrate(b, wo.z, wi.z);
}

template <class Real>
Real ashikhminShirleyPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real density = lobeScale(b) / (2 * kPiOf<Real>)*cosineLobe(wm, b.exponentX, b.exponentY);  // eq. 6
    const Real p = specularShare(b, wo);
    return p * density / (4 * glm::dot(wo, wm)) + (1 - p) * cosinePdf(wi);  // eq. 8
}

template <class Real>
BsdfSample<Real> ashikhminShirleySample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (!choose(uLobe, specularShare(b, wo))) return towards(squareToCosineHemisphere(u));
    return towards(reflectAbout(wo, sampleCosineLobe(b.exponentX, b.exponentY, u)));
}

template <class Real>
bool ashikhminShirleyHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return true;
}

VKPT_INSTANTIATE_BSDF(ashikhminShirley)

}  // namespace vkpt::reference
