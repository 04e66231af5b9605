// Microfacets in double precision, for the tables that are made on the host. Local frame, normal +z. Both renderers
// have their own; their tests hold the tables against them.
#pragma once
#include <glm/glm.hpp>

#include "scene/bsdf_spec.h"

namespace vkpt::facets {

/// Unpolarised reflectance between dielectrics; 1 at total internal reflection. [Walter 07, eq. 22]
[[nodiscard]] double dielectric(double cosine, double eta);

/// Hemispherical mean of a reflectance, weighted by the cosine.
template <class Reflectance>
[[nodiscard]] double hemisphericalMean(const Reflectance& reflectance) {
    constexpr int kSteps = 4096;  // of the sine squared: d(sin^2) = 2 cos sin dθ
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) sum += reflectance(std::sqrt(1 - (i + 0.5) / kSteps));
    return sum / kSteps;
}

/// Facets of one roughness, 0 < alpha.
struct Facets {
    Distribution distribution = Distribution::Ggx;
    Masking masking = Masking::Correlated;
    glm::dvec2 alpha{1};

    /// Density of normals. [Heitz 14, sec. 5.4; Walter 07]
    [[nodiscard]] double d(const glm::dvec3& wm) const;
    /// Smith's Lambda; of phong that of beckmann.
    [[nodiscard]] double lambda(const glm::dvec3& w) const;
    /// Masking and shadowing of a pair of directions; correlated of opposite sides: [Heitz 16, eq. 18]. Not of
    /// V-grooves.
    [[nodiscard]] double g2(const glm::dvec3& wo, const glm::dvec3& wi) const;
};

}  // namespace vkpt::facets
