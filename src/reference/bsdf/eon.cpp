// Energy-preserving Oren-Nayar: Fujii's form of the qualitative model, and a lobe for what it loses. [Portsmouth 25]
#include "reference/bsdf.h"

namespace vkpt::reference {

namespace {

/// Scale of the single-scattering part. [Portsmouth 25, table 1]
template <class Real>
Real scaleOf(Real roughness) {
    return 1 / (1 + (Real(0.5) - 2 / (3 * kPiOf<Real>)) * roughness);
}

/// Albedo of the single-scattering part of a white surface, exact. [Portsmouth 25, eqs. 13 and 14]
template <class Real>
Real albedoOf(Real roughness, const Vec3<Real>& w) {
    const Real sine = std::sqrt(w.x * w.x + w.y * w.y);
    const Real tanTimes = w.z * sine * (1 + sine + sine * sine) / (1 + sine);  // tan (1 - sin^3)
    const Real g = sine * (arcTangent2(sine, w.z) - sine * w.z) + 2 * (tanTimes - sine) / 3;
    return scaleOf(roughness) * (1 + roughness * g / kPiOf<Real>);
}

}  // namespace

template <class Real>
Vec3<Real> eonEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Real s = wo.x * wi.x + wo.y * wi.y;
    const Real shape = s > 0 ? s / std::max(wo.z, wi.z) : s;
    const Real single = scaleOf(b.sigma) * (1 + b.sigma * shape);
    const Real mean = scaleOf(b.sigma) * (1 + (Real(2) / 3 - 28 / (15 * kPiOf<Real>)) * b.sigma);
    if (!(mean < 1)) return b.color * single / kPiOf<Real>;
    const Vec3<Real> tint = b.color * b.color * mean / (Real(1) - b.color * (1 - mean));
    const Real lost = (1 - albedoOf(b.sigma, wo)) * (1 - albedoOf(b.sigma, wi)) / (1 - mean);
    return (b.color * single + tint * std::max(Real(0), lost)) / kPiOf<Real>;
}

VKPT_COSINE_WEIGHTED_BSDF(eon)
VKPT_INSTANTIATE_BSDF(eon)

}  // namespace vkpt::reference
