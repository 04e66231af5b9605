// A microsurface: a distribution of facet normals, and what hides them. Local frame, normal +z. wm.z > 0.
// estimator.md, Microfacets. One instance of each function a precision: facets.cpp.
#pragma once
#include "constants.h"
#include "reference/real.h"

namespace vkpt::reference {

template <class Real>
struct Facets {
    Real alphaX = 1, alphaY = 1;  ///< at least kDeltaAlpha
    std::uint32_t distribution = kDistributionGgx;
    std::uint32_t masking = kMaskingCorrelated;
};

/// choose(u, p) of estimator.md: true with probability p; u becomes a fresh random number.
template <class Real>
[[nodiscard]] bool choose(Real& u, Real p) {
    if (u < p) {
        u /= p;
        return true;
    }
    u = (u - p) / (1 - p);
    return false;
}

/// Density of facet normals: the integral of D cos is 1.
template <class Real>
[[nodiscard]] Real facetD(const Facets<Real>& facets, const Vec3<Real>& wm);

/// Smith's Lambda of a direction on either side.
template <class Real>
[[nodiscard]] Real smithLambda(const Facets<Real>& facets, const Vec3<Real>& w);

/// Share of the facets wm that are seen from w.
template <class Real>
[[nodiscard]] Real maskingG1(const Facets<Real>& facets, const Vec3<Real>& w, const Vec3<Real>& wm);

/// Share of the facets wm that are seen from both directions. Height-correlated from opposite sides: [Heitz 16, eq.
/// 18].
template <class Real>
[[nodiscard]] Real maskingG2(const Facets<Real>& facets, const Vec3<Real>& wo, const Vec3<Real>& wi,
                             const Vec3<Real>& wm);

/// A normal with density D cos.
template <class Real>
[[nodiscard]] Vec3<Real> sampleFacet(const Facets<Real>& facets, const Vec2<Real>& u);

/// A normal as visibleFacetPdf says: seen from wo, but for the distribution phong under Smith's masking.
/// V-grooves choose by `uLobe`.
template <class Real>
[[nodiscard]] Vec3<Real> sampleVisibleFacet(const Facets<Real>& facets, const Vec3<Real>& wo, const Vec2<Real>& u,
                                            Real& uLobe);

/// Density of sampleVisibleFacet, 0 where wm faces away from wo.
template <class Real>
[[nodiscard]] Real visibleFacetPdf(const Facets<Real>& facets, const Vec3<Real>& wo, const Vec3<Real>& wm);

// ---- mirror facets --------------------------------------------------------------------------------------------

/// D G2 / (4 cosO cosI): what facets of reflectance 1 reflect. [Walter 07, eq. 20] 0 below the surface.
template <class Real>
[[nodiscard]] Real facetReflection(const Facets<Real>& facets, const Vec3<Real>& wo, const Vec3<Real>& wi);

/// Density of reflecting wo about sampleVisibleFacet.
template <class Real>
[[nodiscard]] Real facetReflectionPdf(const Facets<Real>& facets, const Vec3<Real>& wo, const Vec3<Real>& wi);

}  // namespace vkpt::reference
