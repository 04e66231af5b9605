// A random walk on Smith's microsurface of GGX facets: light is followed from facet to facet until it leaves. The truth
// that models of interreflection approximate. [Heitz 16] Heights are uniform in [-1, 1]: the result does not depend on
// their distribution. Shares nothing with src/reference.
#pragma once
#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <random>

namespace vkpt::test {

class Microsurface {
public:
    Microsurface(double alpha, std::uint32_t seed) : alpha_(alpha), random_(seed * 2654435761U + 1) {}

    /// Throughput of light that arrives from wo and leaves upwards.
    template <class Fresnel>
    glm::dvec3 reflectMetal(const glm::dvec3& wo, const Fresnel& fresnel) {
        glm::dvec3 ray = -wo, energy(1);
        double height = 1;
        while (true) {
            height = nextHeight(ray, height);
            if (height >= 1) return energy;
            const glm::dvec3 wm = visibleNormal(-ray);
            energy *= fresnel(glm::dot(-ray, wm));
            ray = 2 * glm::dot(-ray, wm) * wm + ray;
            if (energy.x + energy.y + energy.z < 1e-4) return energy;
        }
    }

    /// Whether light that arrives from wo leaves on that side, of a boundary of relative index eta.
    bool reflectGlass(const glm::dvec3& wo, double eta) {
        glm::dvec3 ray = -wo;
        double height = 1;
        bool near = true;  // on the side of wo; on the other the surface is seen upside down
        for (int i = 0; i < 1000; ++i) {
            height = near ? nextHeight(ray, height) : -nextHeight(-ray, -height);
            if (std::abs(height) >= 1) break;
            const glm::dvec3 w = -ray;
            const glm::dvec3 wm = near ? visibleNormal(w) : -visibleNormal(-w);
            const double n = near ? eta : 1 / eta, c = glm::dot(w, wm);
            const double sin2 = (1 - c * c) / (n * n);
            const double cosT = sin2 < 1 ? std::sqrt(1 - sin2) : 0;
            const double s = (c - n * cosT) / (c + n * cosT), p = (n * c - cosT) / (n * c + cosT);
            if (sin2 >= 1 || uniform() < (s * s + p * p) / 2) {
                ray = 2 * c * wm - w;
            } else {
                ray = glm::normalize((c / n - cosT) * wm - w / n);
                near = !near;
            }
        }
        return near;
    }

private:
    double uniform() { return std::uniform_real_distribution<double>()(random_); }

    /// Smith's Lambda with the sign of the direction. [Heitz 16, sec. 4]
    [[nodiscard]] double lambda(const glm::dvec3& w) const {
        const double slope2 = alpha_ * alpha_ * (w.x * w.x + w.y * w.y) / (w.z * w.z);
        return (-1 + (w.z > 0 ? 1 : -1) * std::sqrt(1 + slope2)) / 2;
    }

    /// Height of the next facet along the ray; 1 where it leaves.
    double nextHeight(const glm::dvec3& w, double height) {
        const double u = uniform(), below = std::clamp((height + 1) / 2, 0.0, 1.0);
        if (w.z > 0.99999) return 1;
        if (w.z < -0.99999) return 2 * u * below - 1;
        if (std::abs(w.z) < 1e-6) return height;
        const double l = lambda(w);
        if (w.z > 0 && u > 1 - std::pow(below, l)) return 1;
        return std::min(2 * below / std::pow(1 - u, 1 / l) - 1, 1 - 1e-12);
    }

    /// A facet normal seen from w, which may come from below: a uniform direction of the cap. [Dupuy 23]
    glm::dvec3 visibleNormal(const glm::dvec3& w) {
        const glm::dvec3 wStd = glm::normalize(glm::dvec3(alpha_ * w.x, alpha_ * w.y, w.z));
        const double phi = 2 * std::acos(-1.0) * uniform(), z = (1 - uniform()) * (1 + wStd.z) - wStd.z;
        const double r = std::sqrt(std::max(0.0, 1 - z * z));
        const glm::dvec3 h = wStd + glm::dvec3(r * std::cos(phi), r * std::sin(phi), z);
        return glm::normalize(glm::dvec3(alpha_ * h.x, alpha_ * h.y, h.z));
    }

    double alpha_;
    std::minstd_rand random_;
};

}  // namespace vkpt::test
