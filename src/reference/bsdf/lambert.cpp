// Ideal diffuse reflection.
#include "reference/bsdf.h"

namespace vkpt::reference {

template <class Real>
Vec3<Real> lambertEval(const Bsdf<Real>& b, const Vec3<Real>&, const Vec3<Real>& wi) {
    return wi.z > 0 ? b.color / kPiOf<Real> : Vec3<Real>(0);
}

template <class Real>
Real lambertPdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>& wi) {
    return cosinePdf(wi);
}

template <class Real>
BsdfSample<Real> lambertSample(const Bsdf<Real>&, const Vec3<Real>&, Real, const Vec2<Real>& u) {
    return towards(squareToCosineHemisphere(u));
}

template <class Real>
bool lambertHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return true;
}

VKPT_INSTANTIATE_BSDF(lambert)

}  // namespace vkpt::reference
