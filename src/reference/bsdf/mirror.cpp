// An ideal mirror.
#include "reference/bsdf.h"

namespace vkpt::reference {

template <class Real>
Vec3<Real> mirrorEval(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&) {
    return Vec3<Real>(0);
}

template <class Real>
Real mirrorPdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&) {
    return 0;
}

template <class Real>
BsdfSample<Real> mirrorSample(const Bsdf<Real>& b, const Vec3<Real>& wo, Real, const Vec2<Real>&) {
    return deltaSample(mirrored(wo), b.color);
}

template <class Real>
bool mirrorHasDensity(const Bsdf<Real>&, const Vec3<Real>&) {
    return false;
}

VKPT_INSTANTIATE_BSDF(mirror)

}  // namespace vkpt::reference
