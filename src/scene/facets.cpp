#include "scene/facets.h"

#include <cmath>
#include <numbers>

namespace vkpt::facets {
namespace {

/// Euler's Beta function.
double beta(double x, double y) {
    int sign = 0;
    return std::exp(lgamma_r(x, &sign) + lgamma_r(y, &sign) - lgamma_r(x + y, &sign));
}

}  // namespace

double dielectric(double cosine, double eta) {
    const double sin2 = (1 - cosine * cosine) / (eta * eta);
    if (sin2 >= 1) return 1;
    const double cosT = std::sqrt(1 - sin2);
    const double s = (cosine - eta * cosT) / (cosine + eta * cosT);
    const double p = (eta * cosine - cosT) / (eta * cosine + cosT);
    return (s * s + p * p) / 2;
}

double Facets::d(const glm::dvec3& wm) const {
    using std::numbers::pi;
    if (wm.z <= 0) return 0;
    const double z2 = wm.z * wm.z;
    const double slope = wm.x * wm.x / (alpha.x * alpha.x) + wm.y * wm.y / (alpha.y * alpha.y);
    switch (distribution) {
        case Distribution::Ggx: {
            const double t = slope + z2;
            return 1 / (pi * alpha.x * alpha.y * t * t);
        }
        case Distribution::Beckmann:
            return std::exp(-slope / z2) / (pi * alpha.x * alpha.y * z2 * z2);
        case Distribution::Phong: {
            const glm::dvec2 e = 2.0 / (alpha * alpha) - 2.0;
            const double sin2 = wm.x * wm.x + wm.y * wm.y;
            const double power = sin2 > 0 ? (e.x * wm.x * wm.x + e.y * wm.y * wm.y) / sin2 : e.x;
            return std::sqrt((e.x + 2) * (e.y + 2)) / (2 * pi) * std::pow(wm.z, power);
        }
    }
    return 0;
}

double Facets::lambda(const glm::dvec3& w) const {
    const double spread = std::hypot(alpha.x * w.x, alpha.y * w.y);
    if (spread == 0) return 0;
    const double a = std::abs(w.z) / spread;
    if (distribution == Distribution::Ggx) return (std::sqrt(1 + 1 / (a * a)) - 1) / 2;
    return (std::exp(-a * a) / (a * std::sqrt(std::numbers::pi)) - std::erfc(a)) / 2;
}

double Facets::g2(const glm::dvec3& wo, const glm::dvec3& wi) const {
    const double o = lambda(wo), i = lambda(wi);
    if (masking == Masking::Separable) return 1 / ((1 + o) * (1 + i));
    return wo.z * wi.z < 0 ? beta(1 + o, 1 + i) : 1 / (1 + o + i);
}

}  // namespace vkpt::facets
