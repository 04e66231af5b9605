// What is to be known of a BSDF, measured in double precision: energy, densities, reciprocity, sampling.
#pragma once
#include <cstdint>

#include "compare/statistics.h"
#include "reference/bsdf.h"

namespace vkpt {

using BsdfDouble = reference::Bsdf<double>;

/// Integrals over all directions of arrival; the lobes that are deltas are counted too.
struct BsdfIntegrals {
    glm::dvec3 reflected{0};    ///< albedo
    glm::dvec3 transmitted{0};  ///< as flux: radiance times eta^2
    double pdf = 0;             ///< of the lobes with a density

    [[nodiscard]] glm::dvec3 albedo() const { return reflected + transmitted; }
};

[[nodiscard]] BsdfIntegrals integrateBsdf(const BsdfDouble& b, const glm::dvec3& wo);

/// What draws of sampleBsdf say. Random numbers are hashed from `seed`.
struct BsdfDraws {
    double invalid = 0;           ///< share without a direction
    double delta = 0;             ///< share that delta lobes took
    glm::dvec3 mean{0};           ///< of the weights; flux where transmitted
    double relativeVariance = 0;  ///< of the luminance of a weight, over the square of its mean
    double largest = 0;           ///< luminance of a weight
};

[[nodiscard]] BsdfDraws drawBsdf(const BsdfDouble& b, const glm::dvec3& wo, std::uint32_t count, std::uint32_t seed);

/// Chi-square test of the directions that `b` draws against the density of `claimed`, on a grid of cells over the
/// sphere. Draws without a direction and delta lobes are left out: their share is what the density lacks to 1.
[[nodiscard]] TestResult testBsdfDraws(const BsdfDouble& b, const BsdfDouble& claimed, const glm::dvec3& wo,
                                       std::uint32_t count, std::uint32_t seed);
[[nodiscard]] inline TestResult testBsdfDraws(const BsdfDouble& b, const glm::dvec3& wo, std::uint32_t count,
                                              std::uint32_t seed) {
    return testBsdfDraws(b, b, wo, count, seed);
}

/// Largest |f(wo, wi) - f(wi, wo)| / (f(wo, wi) + f(wi, wo)) of `pairs` pairs; f times eta where light goes through.
/// `back` is the BSDF seen from its other side, where it transmits.
[[nodiscard]] double reciprocityError(const BsdfDouble& b, const BsdfDouble& back, std::uint32_t pairs,
                                      std::uint32_t seed);

}  // namespace vkpt
