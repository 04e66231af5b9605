// glTF's BRDF in its textbook form, double precision, written for the tests alone: [Walter 07, eqs. 33 and 34] with
// tangents, [Heitz 14, eq. 99] with Lambda. Shares nothing with src/reference.
#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace vkpt::test {

inline double lambdaOf(double cosine, double alpha) {
    const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
    return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

/// f, cosine excluded; +z is the normal, both directions above.
inline glm::dvec3 gltfOracle(const glm::dvec3& base, double metallic, double roughness, const glm::dvec3& wo,
                             const glm::dvec3& wi) {
    const double pi = std::acos(-1.0), alpha = roughness * roughness;
    const glm::dvec3 h = glm::normalize(wo + wi);
    const double cos2 = h.z * h.z, tan2 = (1 - cos2) / cos2;
    const double d = alpha * alpha / (pi * cos2 * cos2 * std::pow(alpha * alpha + tan2, 2));
    const double g = 1 / (1 + lambdaOf(wo.z, alpha) + lambdaOf(wi.z, alpha));
    const double weight = std::pow(1 - std::abs(glm::dot(wo, h)), 5);
    const double fd = 0.04 + (1 - 0.04) * weight;
    glm::dvec3 f(0);
    for (int i = 0; i < 3; ++i) {
        const double dielectric = (1 - fd) * base[i] / pi + fd * d * g / (4 * wo.z * wi.z);
        const double metal = (base[i] + (1 - base[i]) * weight) * d * g / (4 * wo.z * wi.z);
        f[i] = (1 - metallic) * dielectric + metallic * metal;
    }
    return f;
}

/// Reflectance towards wo under uniform light: the integral of f cos over the hemisphere.
inline glm::dvec3 gltfAlbedo(const glm::dvec3& base, double metallic, double roughness, double cosO, int steps = 400) {
    const glm::dvec3 wo(std::sqrt(1 - cosO * cosO), 0, cosO);
    glm::dvec3 sum(0);
    for (int i = 0; i < steps; ++i) {
        const double cosI = std::sqrt((i + 0.5) / steps), sinI = std::sqrt(1 - cosI * cosI);
        for (int j = 0; j < steps; ++j) {
            const double phi = 2 * std::acos(-1.0) * (j + 0.5) / steps;
            sum += gltfOracle(base, metallic, roughness, wo, {sinI * std::cos(phi), sinI * std::sin(phi), cosI});
        }
    }
    return sum * (std::acos(-1.0) / steps / steps);  // d cos^2 = 2 cos d cos
}

}  // namespace vkpt::test
