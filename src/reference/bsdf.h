// glTF 2.0 metallic-roughness (specification, appendix B): Lambert under a GGX layer. Local frame, normal +z;
// wo and wi point away from the surface; f excludes the cosine; pdf is per solid angle.
#pragma once
#include <limits>

#include "constants.h"
#include "reference/bsdf/fresnel.h"
#include "reference/bsdf/ggx.h"
#include "reference/warp.h"

namespace vkpt::reference {

template <class Real>
struct Bsdf {
    Vec3<Real> base{1};
    Real metallic = 0;
    Real alpha = 1;      ///< roughness squared
    Real pSpecular = 1;  ///< probability of the specular lobe

    /// The specular lobe is a mirror and takes no part in f and pdf.
    [[nodiscard]] bool isDelta() const { return alpha < Real(kDeltaAlpha); }
    /// False where a mirror is all there is: then light sampling is of no use.
    [[nodiscard]] bool hasDensity() const { return !isDelta() || pSpecular < 1; }
};

/// F = mix(Fd, Fm, metallic).
template <class Real>
[[nodiscard]] Vec3<Real> specularFresnel(const Bsdf<Real>& b, Real cosine) {
    const Real w = schlickWeight(cosine);
    const Real fd = Real(kDielectricF0) + (1 - Real(kDielectricF0)) * w;
    const Vec3<Real> fm = b.base + (Real(1) - b.base) * w;
    return glm::mix(Vec3<Real>(fd), fm, b.metallic);
}

/// What Fresnel leaves for the diffuse lobe: (1 - metallic) (1 - Fd) base.
template <class Real>
[[nodiscard]] Vec3<Real> diffuseAlbedo(const Bsdf<Real>& b, Real cosine) {
    const Real fd = Real(kDielectricF0) + (1 - Real(kDielectricF0)) * schlickWeight(cosine);
    return (1 - b.metallic) * (1 - fd) * b.base;
}

/// The BSDF seen from a direction at cosine cosO = |wo.z|: chooses pSpecular by the luminances of both lobes.
template <class Real>
[[nodiscard]] Bsdf<Real> makeBsdf(const Vec3<Real>& base, Real metallic, Real roughness, Real cosO) {
    Bsdf<Real> b{base, metallic, roughness * roughness, 1};
    const Real s = luminance(specularFresnel(b, cosO));
    const Real d = luminance(diffuseAlbedo(b, cosO));
    if (s + d > 0) b.pSpecular = s / (s + d);
    return b;
}

/// f(wo, wi) of the lobes that are not delta.
template <class Real>
[[nodiscard]] Vec3<Real> evalBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wo.z <= 0 || wi.z <= 0) return Vec3<Real>(0);
    const Vec3<Real> wm = glm::normalize(wo + wi);
    const Real cosine = std::abs(glm::dot(wo, wm));
    const Vec3<Real> diffuse = diffuseAlbedo(b, cosine) / kPiOf<Real>;
    if (b.isDelta()) return diffuse;
    return diffuse + specularFresnel(b, cosine) * (ggxD(wm, b.alpha) * ggxVisibility(wo.z, wi.z, b.alpha));
}

/// Density with which sampleBsdf draws wi through the lobes that are not delta.
template <class Real>
[[nodiscard]] Real pdfBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, const Vec3<Real>& wi) {
    if (wo.z <= 0 || wi.z <= 0) return 0;
    const Real diffuse = (1 - b.pSpecular) * wi.z / kPiOf<Real>;
    if (b.isDelta()) return diffuse;
    const Vec3<Real> wm = glm::normalize(wo + wi);
    return b.pSpecular * ggxD(wm, b.alpha) * ggxG1(wo.z, b.alpha) / (4 * wo.z) + diffuse;
}

template <class Real>
struct BsdfSample {
    Vec3<Real> wi{0, 0, 1};
    Vec3<Real> weight{0};  ///< f cos / pdf; black where the direction is invalid
    Real pdf = 0;          ///< infinite for a delta lobe
};

/// Draws wi: `uLobe` chooses the lobe, `u` its direction.
template <class Real>
[[nodiscard]] BsdfSample<Real> sampleBsdf(const Bsdf<Real>& b, const Vec3<Real>& wo, Real uLobe, const Vec2<Real>& u) {
    BsdfSample<Real> sample;
    if (wo.z <= 0) return sample;
    const bool specular = uLobe < b.pSpecular;
    if (specular && b.isDelta()) {
        sample.wi = {-wo.x, -wo.y, wo.z};
        sample.weight = specularFresnel(b, wo.z) / b.pSpecular;
        sample.pdf = std::numeric_limits<Real>::infinity();
        return sample;
    }
    if (specular) {
        const Vec3<Real> wm = sampleGgxVisibleNormal(wo, b.alpha, u);
        sample.wi = 2 * glm::dot(wo, wm) * wm - wo;
    } else {
        sample.wi = squareToCosineHemisphere(u);
    }
    sample.pdf = pdfBsdf(b, wo, sample.wi);
    if (sample.pdf > 0) sample.weight = evalBsdf(b, wo, sample.wi) * (sample.wi.z / sample.pdf);
    return sample;
}

}  // namespace vkpt::reference
