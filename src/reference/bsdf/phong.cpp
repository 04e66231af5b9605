// Phong's cosine lobe around the mirror direction, over a diffuse part. [Phong 75], normalised as in [Lafortune 94].
#include "reference/bsdf.h"
#include "reference/bsdf/cosine_lobes.h"
#include "reference/frame.h"

namespace vkpt::reference {

namespace {

/// (r . wi)^e, r the mirror direction of wo.
template <class Real>
Real lobeOf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    const Vec3<Real> r = mirrored(wo);
    const Real cosine = glm::dot(r, wi);
    if (cosine <= 0) return 0;
    const Vec3<Real> across = glm::cross(r, wi);
    return powerOfCosine(cosine, std::min(Real(1), glm::dot(across, across)), b.exponentX);
}

}  // namespace

template <class Real>
Vec3<Real> phongEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    return (b.diffuse + b.color * ((b.exponentX + 2) / 2 * lobeOf(b, wo, wi))) / kPiOf<Real>;
}

template <class Real>
Real phongPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Real p = cosineLobeShare(b);
    return p * (b.exponentX + 1) / (2 * kPiOf<Real>)*lobeOf(b, wo, wi) + (1 - p) * cosinePdf(wi);
}

template <class Real>
BsdfSample<Real> phongSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (!choose(uLobe, cosineLobeShare(b))) return towards(squareToCosineHemisphere(u));
    return towards(Frame<Real>(mirrored(wo)).toWorld(sampleRoundLobe(b.exponentX, u)));
}

template <class Real>
bool phongHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return true;
}

VKPT_INSTANTIATE_BSDF(phong)

}  // namespace vkpt::reference
