// What every BSDF model works on: its parameters at a point, seen from one side. Local frame, normal +z; wo and wi
// point away from the surface, wo.z > 0; f excludes the cosine; pdf is per solid angle. A model is one file in this
// folder that defines, for the stem of its registry line, the functions that bsdf.h declares, and ends with
// VKPT_INSTANTIATE_BSDF(stem).
#pragma once
#include "reference/bsdf/albedo_table.h"
#include "reference/microfacet/facets.h"
#include "reference/microfacet/fresnel.h"
#include "reference/warp.h"
#include "registry.h"

namespace vkpt::reference {

/// Parameters after textures. Which a model reads: estimator.md, BSDF models. gltf reads color as its base colour,
/// metallic and alphaX.
template <class Real>
struct Bsdf {
    BsdfId model = BsdfId::Gltf;
    std::uint32_t flags = 0;  ///< kBsdf*
    Vec3<Real> color{1}, diffuse{0};
    Vec3<Real> eta{1}, k{0};  ///< dielectrics: eta.x is that of the far side over that of wo's
    Vec3<Real> average{0};    ///< of a dielectric's Fresnel term: x from outside, y from inside
    Real metallic = 0;
    Real alphaX = 1, alphaY = 1;  ///< as given: may be below kDeltaAlpha
    Real exponentX = 0, exponentY = 0;
    Real sigma = 0, weight = 1, specular = 1;
    AlbedoTable table;          ///< dielectrics: of the side of wo
    AlbedoTable farTable;       ///< dielectrics: of the other side
    bool multiscatter = false;  ///< interreflection between facets is compensated

    /// The microfacet lobe is a mirror and takes no part in f and pdf.
    [[nodiscard]] bool isDelta() const { return std::max(alphaX, alphaY) < Real(kDeltaAlpha); }
    /// There are lobes that make good for what facets lose.
    [[nodiscard]] bool compensates() const { return multiscatter && table.exists() && !isDelta(); }
    [[nodiscard]] Facets<Real> facets() const {
        return {std::max(alphaX, Real(kDeltaAlpha)), std::max(alphaY, Real(kDeltaAlpha)), flags & kBsdfDistributionMask,
                (flags >> kBsdfMaskingShift) & kBsdfMaskingMask};
    }
};

template <class Real>
struct BsdfSample {
    Vec3<Real> wi{0};      ///< zero where there is none
    Vec3<Real> weight{0};  ///< f |cos| / pdf; black where the direction is invalid
    Real pdf = 0;          ///< infinite for a delta lobe
};

/// A direction, of which sampleBsdf finds pdf and weight.
template <class Real>
[[nodiscard]] BsdfSample<Real> towards(const Vec3<Real>& wi) {
    return {wi};
}

template <class Real>
[[nodiscard]] BsdfSample<Real> deltaSample(const Vec3<Real>& wi, const Vec3<Real>& weight) {
    return {wi, weight, std::numeric_limits<Real>::infinity()};
}

/// The mirror direction of w about the normal.
template <class Real>
[[nodiscard]] Vec3<Real> mirrored(const Vec3<Real>& w) {
    return {-w.x, -w.y, w.z};
}

/// Density of squareToCosineHemisphere.
template <class Real>
[[nodiscard]] Real cosinePdf(const Vec3<Real>& wi) {
    return std::max(Real(0), wi.z) / kPiOf<Real>;
}

/// Probability of the first of two lobes of these sizes; 1 where both are black.
template <class Real>
[[nodiscard]] Real shareOf(Real first, Real second) {
    return first + second > 0 ? first / (first + second) : Real(1);
}

/// Fresnel term of the facets.
template <class Real>
[[nodiscard]] Vec3<Real> facetFresnel(const Bsdf<Real>& b, Real cosine) {
    if ((b.flags & kBsdfMetal) != 0) return conductorFresnel(cosine, b.eta, b.k);
    return Vec3<Real>(dielectricFresnel(cosine, b.eta.x));
}

/// The roughness that stands for both.
template <class Real>
[[nodiscard]] Real meanAlpha(const Bsdf<Real>& b) {
    const Facets<Real> f = b.facets();
    return std::sqrt(f.alphaX * f.alphaY);
}

/// The row of an albedo table for a roughness, in [0, 1]: even in the fourth root from kDeltaAlpha on.
template <class Real>
[[nodiscard]] Real albedoRow(Real alpha) {
    const Real least = std::sqrt(std::sqrt(Real(kDeltaAlpha)));
    return std::clamp((std::sqrt(std::sqrt(alpha)) - least) / (1 - least), Real(0), Real(1));
}

/// Where the albedo table has a direction.
template <class Real>
[[nodiscard]] TablePlace<Real> albedoPlace(const Bsdf<Real>& b, const Vec3<Real>& w) {
    const bool azimuths = (b.flags & kBsdfAzimuthTable) != 0;
    const Facets<Real> f = b.facets();
    const Real alpha = meanAlpha(b), cosine = std::min(Real(1), std::abs(w.z));
    const Vec2<Real> stretched = azimuths ? Vec2<Real>(f.alphaX * w.x, f.alphaY * w.y) : alpha * Vec2<Real>(w.x, w.y);
    const Real spread = std::sqrt(glm::dot(stretched, stretched));
    const Real column = (std::sqrt(cosine) + std::sqrt(std::sqrt(cosine / (cosine + spread)))) / 2;
    const Real row = azimuths ? arcTangent2(std::abs(w.y), std::abs(w.x)) / (kPiOf<Real> / 2) : albedoRow(alpha);
    return {std::min(Real(1), column), std::min(Real(1), row)};
}

/// Means of a table of this BSDF.
template <class Real>
[[nodiscard]] Albedo<Real> albedoMean(const Bsdf<Real>& b, const AlbedoTable& table) {
    const Real alpha = meanAlpha(b);
    // Rows of azimuths have all the same.
    return table.mean(albedoRow(alpha), alpha);
}

#define VKPT_INSTANTIATE_BSDF_FOR(stem, Real)                                                              \
    template Vec3<Real> stem##Eval(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&);               \
    template Real stem##Pdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>&);                      \
    template BsdfSample<Real> stem##Sample(const Bsdf<Real>&, const Vec3<Real>&, Real, const Vec2<Real>&); \
    template bool stem##HasDensity(const Bsdf<Real>&, const Vec3<Real>&);
/// Density and draws of a model that is nothing but diffuse: cosine-weighted.
#define VKPT_COSINE_WEIGHTED_BSDF(stem)                                                              \
    template <class Real>                                                                            \
    Real stem##Pdf(const Bsdf<Real>&, const Vec3<Real>&, const Vec3<Real>& wi) {                     \
        return cosinePdf(wi);                                                                        \
    }                                                                                                \
    template <class Real>                                                                            \
    BsdfSample<Real> stem##Sample(const Bsdf<Real>&, const Vec3<Real>&, Real, const Vec2<Real>& u) { \
        return towards(squareToCosineHemisphere(u));                                                 \
    }                                                                                                \
    template <class Real>                                                                            \
    bool stem##HasDensity(const Bsdf<Real>&, const Vec3<Real>&) {                                    \
        return true;                                                                                 \
    }

#define VKPT_INSTANTIATE_BSDF(stem)        \
    VKPT_INSTANTIATE_BSDF_FOR(stem, float) \
    VKPT_INSTANTIATE_BSDF_FOR(stem, double)

}  // namespace vkpt::reference
