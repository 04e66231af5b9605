// Ideal diffuse reflection.
#include "reference/bsdf.h"

namespace vkpt::reference {

template <class Real>
Vec3<Real> lambertEval(const Bsdf<Real>& b, const Vec3<Real>&, const Vec3<Real>& wi) {
    return wi.z > 0 ? b.color / kPiOf<Real> : Vec3<Real>(0);
}

VKPT_COSINE_WEIGHTED_BSDF(lambert)
VKPT_INSTANTIATE_BSDF(lambert)

}  // namespace vkpt::reference
