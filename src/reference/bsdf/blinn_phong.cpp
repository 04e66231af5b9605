// Blinn's cosine lobe around the half vector, over a diffuse part. [Blinn 77] Normalised as the lecture has it, which
// gains energy, or so that the albedo at normal incidence is the colour [Giesen 09].
#include "reference/bsdf.h"
#include "reference/bsdf/cosine_lobes.h"

namespace vkpt::reference {

namespace {

template <class Real>
Real normalization(const Bsdf<Real>& b) {
    const Real e = b.exponentX;
    if ((b.flags & kBsdfConserving) == 0) return (e + 2) / (2 * kPiOf<Real>);
    return (e + 2) * (e + 4) / (8 * kPiOf<Real> * (std::exp2(-e / 2) + e));
}

template <class Real>
Real lobeOf(const Bsdf<Real>& b, const Vec3<Real>& wm) {
    return cosineLobe(wm, b.exponentX, b.exponentX);
}

}  // namespace

template <class Real>
Vec3<Real> blinnPhongEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    return b.diffuse / kPiOf<Real> + b.color * (normalization(b) * lobeOf(b, glm::normalize(wo + wi)));
}

template <class Real>
Real blinnPhongPdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return 0;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real p = cosineLobeShare(b);
    const Real density = (b.exponentX + 1) / (2 * kPiOf<Real>)*lobeOf(b, wm) / (4 * glm::dot(wo, wm));
    return p * density + (1 - p) * cosinePdf(wi);
}

template <class Real>
BsdfSample<Real> blinnPhongSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    if (!choose(uLobe, cosineLobeShare(b))) return towards(squareToCosineHemisphere(u));
    return towards(reflectAbout(wo, sampleRoundLobe(b.exponentX, u)));
}

template <class Real>
bool blinnPhongHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return true;
}

VKPT_INSTANTIATE_BSDF(blinnPhong)

}  // namespace vkpt::reference
