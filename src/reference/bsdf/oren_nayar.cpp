// Lambertian facets in V-shaped cavities whose slopes are Gaussian: the full functional model, direct light and one
// interreflection. [Oren 94, eqs. 30 to 32]
#include "reference/bsdf.h"

namespace vkpt::reference {

namespace {

/// What both terms read of a pair of directions.
template <class Real>
struct Azimuths {
    Real cosPhi;                         ///< of the difference of the azimuths
    Real alpha, beta;                    ///< the larger and the smaller angle to the normal
    Real sinAlpha, tanBeta, tanHalfSum;  ///< the last of (alpha + beta) / 2

    Azimuths(const Vec3<Real>& wo, const Vec3<Real>& wi) {
        const Real sinO = std::sqrt(wo.x * wo.x + wo.y * wo.y), sinI = std::sqrt(wi.x * wi.x + wi.y * wi.y);
        const Real product = sinO * sinI;
        cosPhi = product > 0 ? std::clamp((wo.x * wi.x + wo.y * wi.y) / product, Real(-1), Real(1)) : Real(0);
        const Real thetaO = arcTangent2(sinO, wo.z), thetaI = arcTangent2(sinI, wi.z);
        const bool outerIsWo = wo.z < wi.z;
        alpha = outerIsWo ? thetaO : thetaI;
        beta = outerIsWo ? thetaI : thetaO;
        sinAlpha = outerIsWo ? sinO : sinI;
        tanBeta = outerIsWo ? sinI / wi.z : sinO / wo.z;
        tanHalfSum = (sinO + sinI) / (wo.z + wi.z);
    }
};

}  // namespace

template <class Real>
Vec3<Real> orenNayarEval(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wi.z <= 0) return Vec3<Real>(0);
    const Azimuths<Real> at(wo, wi);
    const Real s2 = b.sigma * b.sigma, rough = s2 / (s2 + Real(0.09));
    const Real b2 = 2 * at.beta / kPiOf<Real>, ab = 4 * at.alpha * at.beta / (kPiOf<Real> * kPiOf<Real>);
    const Real c1 = 1 - s2 / (2 * (s2 + Real(0.33)));
    const Real c2 = Real(0.45) * rough * (at.cosPhi >= 0 ? at.sinAlpha : at.sinAlpha - b2 * b2 * b2);
    const Real c3 = Real(0.125) * rough * ab * ab;
    const Real direct = c1 + at.cosPhi * c2 * at.tanBeta + (1 - std::abs(at.cosPhi)) * c3 * at.tanHalfSum;
    const Real interreflected = Real(0.17) * s2 / (s2 + Real(0.13)) * (1 - at.cosPhi * b2 * b2);
    return glm::max(Vec3<Real>(0), b.color / kPiOf<Real> * (direct + b.color * interreflected));
}

VKPT_COSINE_WEIGHTED_BSDF(orenNayar)
VKPT_INSTANTIATE_BSDF(orenNayar)

}  // namespace vkpt::reference
