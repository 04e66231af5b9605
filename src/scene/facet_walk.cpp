#include "scene/facet_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "scene/facets.h"

namespace vkpt::facets {
namespace {

constexpr int kWalks = 32768;
constexpr int kMostFacets = 1000;  ///< nearly all leave after five

/// One walk. The microsurface lies at heights from 0 (all facets are above) to 1 (none is): heights are uniform, on
/// which the result does not depend.
class Walker {
public:
    Walker(double alpha, std::mt19937& random) : alpha_(alpha), random_(random) {}

    /// Height of the next facet that a ray meets which climbs along w from `height`; 1 where it leaves.
    double meet(const glm::dvec3& w, double height) {
        const double u = uniform(), spread = alpha_ * std::hypot(w.x, w.y);
        if (spread <= 1e-9 * std::abs(w.z)) return w.z > 0 ? 1 : u * height;
        if (w.z == 0) return height;
        const double cot = w.z / spread;
        const double lambda = (std::copysign(std::sqrt(1 + 1 / (cot * cot)), cot) - 1) / 2;
        const double next = height * std::exp(-std::log1p(-u) / lambda);  // the way up passes G1 = height^lambda
        return next >= 1 ? 1 : next;
    }

    /// The normal of a facet that w sees, which may look up from below. [Dupuy 23]
    glm::dvec3 facetSeenFrom(const glm::dvec3& w) {
        const glm::dvec3 s = glm::normalize(glm::dvec3(alpha_ * w.x, alpha_ * w.y, w.z));
        const double z = (1 - uniform()) * (1 + s.z) - s.z, r = std::sqrt(std::max(0.0, 1 - z * z));
        const double phi = 2 * std::numbers::pi * uniform();
        const glm::dvec3 h = s + glm::dvec3(r * std::cos(phi), r * std::sin(phi), z);
        return glm::normalize(glm::dvec3(alpha_ * h.x, alpha_ * h.y, h.z));
    }

    double uniform() { return (random_() + 0.5) * 0x1p-32; }

private:
    double alpha_;
    std::mt19937& random_;
};

/// Weighted sums for lines over x.
class Fit {
public:
    void add(double weight, double x, double y) {
        w_ += weight;
        x_ += weight * x;
        xx_ += weight * x * x;
        y_ += weight * y;
        xy_ += weight * x * y;
    }
    [[nodiscard]] double mean() const { return w_ > 0 ? y_ / w_ : 0; }
    [[nodiscard]] Line line() const {
        const double spread = w_ * xx_ - x_ * x_;
        const double slope = spread > 0 ? (w_ * xy_ - x_ * y_) / spread : 0;
        const double at0 = w_ > 0 ? (y_ - slope * x_) / w_ : 0;
        return {at0, at0 + slope};
    }

private:
    double w_ = 0, x_ = 0, xx_ = 0, y_ = 0, xy_ = 0;
};

/// walk(wo, weight) from directions of uniform light, most of them where much of it meets a second facet: the square of
/// their cosine is log-uniform from about alpha^2 on.
template <class Walk>
void forEachDirection(double alpha, const Walk& walk) {
    const double c = alpha * alpha, span = std::log1p(1 / c);
    for (int i = 0; i < kWalks; ++i) {
        const double cos2 = std::min(1.0, c * std::expm1(span * (i + 0.5) / kWalks));
        walk(glm::dvec3(std::sqrt(1 - cos2), 0, std::sqrt(cos2)), (cos2 + c) * span);
    }
}

}  // namespace

MetalWalk walkOnMetal(double alpha) {
    std::mt19937 random(1);
    Walker walker(alpha, random);
    Fit more, angle;
    forEachDirection(alpha, [&](const glm::dvec3& wo, double weight) {
        glm::dvec3 w = -wo;
        double height = 1, angles = 0;
        int facets = 0;
        while ((height = walker.meet(w, height)) < 1 && facets < kMostFacets) {
            const glm::dvec3 wm = walker.facetSeenFrom(-w);
            const double cosine = std::min(1.0, glm::dot(-w, wm));
            angles += std::pow(1 - cosine, 3);
            w += 2 * cosine * wm;
            ++facets;
        }
        if (facets < 2) return;
        const double x = (1 - wo.z) * (1 - wo.z);
        more.add(weight, x, facets - 1);
        angle.add(weight, x, angles / facets);
    });
    return {more.line(), angle.line()};
}

GlassWalk walkOnGlass(double alpha, double eta) {
    std::mt19937 random(1);
    Walker walker(alpha, random);
    Fit through;
    forEachDirection(alpha, [&](const glm::dvec3& wo, double weight) {
        // Beyond the surface all is seen upside down: w, and the height.
        glm::dvec3 w = -wo;
        double height = 1, n = eta;
        bool beyond = false;
        int facets = 0;
        while ((height = walker.meet(w, height)) < 1 && facets < kMostFacets) {
            const glm::dvec3 wm = walker.facetSeenFrom(-w);
            const double cosine = std::min(1.0, glm::dot(-w, wm));
            ++facets;
            if (walker.uniform() < dielectric(cosine, n)) {
                w += 2 * cosine * wm;
                continue;
            }
            const double cosT = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (n * n)));
            w = -glm::normalize((cosine / n - cosT) * wm + w / n);
            height = 1 - height;
            beyond = !beyond;
            n = beyond ? 1 / eta : eta;
        }
        if (facets >= 2) through.add(weight, wo.z * wo.z * (2 - wo.z), beyond ? 1 : 0);
    });
    return {through.mean(), through.line()};
}

}  // namespace vkpt::facets
