#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "scene/albedo_tables.h"
#include "scene/facet_walk.h"
#include "scene/facets.h"

namespace vkpt {
namespace {

constexpr std::size_t kSide = kAlbedoSide;
struct Albedo {
    double second = 0, lost = 0;  ///< what is left of 1 is first
};
using Column = std::array<Albedo, kSide>;  ///< at each place of one row

/// A normal visible from wo under GGX: the change of variables of the quadrature. [Dupuy 23]
glm::dvec3 visibleNormal(const glm::dvec3& wo, const glm::dvec2& alpha, double u0, double u1) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(wo.x * alpha.x, wo.y * alpha.y, wo.z));
    const double z = (1 - u1) * (1 + w.z) - w.z, r = std::sqrt(std::max(0.0, 1 - z * z));
    const double phi = 2 * std::numbers::pi * u0;
    const glm::dvec3 h = glm::dvec3(r * std::cos(phi), r * std::sin(phi), z) + w;
    return glm::normalize(glm::dvec3(h.x * alpha.x, h.y * alpha.y, h.z));
}

/// (part that Schlick's F scales with F0, the rest) of a conductor; (reflected, transmitted) of a dielectric.
glm::dvec2 ofFacet(double cosine, double eta) {
    if (eta == 0) {
        const double rest = std::pow(1 - cosine, 5);
        return {1 - rest, rest};
    }
    const double f = facets::dielectric(cosine, eta);
    return {f, 1 - f};
}

/// What masking shows of the facets is what they reflect, transmit or lose: summed like that, little is not the
/// difference of much. Phong's masking is not its own: there the sum gains energy where grazing, and nothing is lost.
Albedo albedo(const AlbedoTableKey& key, const facets::Facets& facets, const glm::dvec3& wo) {
    constexpr int kSteps = 64;
    const facets::Facets ggx{Distribution::Ggx, key.masking, facets.alpha};
    const double ggxG1 = 1 / (1 + ggx.lambda(wo)), g1 = 1 / (1 + facets.lambda(wo));
    const bool owns = key.distribution != Distribution::Phong;
    double first = 0;
    Albedo sum;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const auto wm = visibleNormal(wo, facets.alpha, (i + 0.5) / kSteps, (j + 0.5) / kSteps);
            const double cosine = glm::dot(wo, wm);
            if (cosine <= 0) continue;
            const double density = facets.d(wm) / (ggx.d(wm) * ggxG1);
            const glm::dvec2 share = ofFacet(cosine, key.eta);
            const glm::dvec3 reflected = 2 * cosine * wm - wo;
            const double seen = reflected.z > 0 ? facets.g2(wo, reflected) : 0;
            double second = key.eta == 0 ? seen * share.y : 0;
            if (key.eta != 0 && share.y > 0) {
                const double cosT = std::sqrt(1 - (1 - cosine * cosine) / (key.eta * key.eta));
                const glm::dvec3 transmitted = (cosine / key.eta - cosT) * wm - wo / static_cast<double>(key.eta);
                if (transmitted.z < 0) second = facets.g2(wo, transmitted) * share.y;
            }
            first += density * seen * share.x;
            sum.second += density * second;
            sum.lost += density * (g1 - seen * share.x - second);
        }
    }
    constexpr double kPlaces = kSteps * kSteps;
    if (!owns) sum.lost = kPlaces - first - sum.second;
    if (sum.lost < 0) sum.second = std::clamp(kPlaces - first, 0.0, sum.second);
    return {sum.second / kPlaces, std::max(0.0, sum.lost / kPlaces)};
}

/// From kDeltaAlpha to 1, evenly in the fourth root.
double alphaOfRow(std::size_t row) {
    const double least = std::pow(double{kDeltaAlpha}, 0.25);
    return std::pow(least + (1 - least) * static_cast<double>(row) / (kSide - 1), 4);
}

/// Place of a direction in [0, 1]: half of it follows Fresnel, half the shape that all small alphas share where
/// grazing.
double placeOf(double cosine, double spread) {
    return (std::sqrt(cosine) + std::sqrt(std::sqrt(cosine / (cosine + spread)))) / 2;
}

/// The cosine at a place; spread / sine is `alpha`.
double cosineAt(double place, double alpha) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double c = (low + high) / 2;
        (placeOf(c, alpha * std::sqrt(1 - c * c)) < place ? low : high) = c;
    }
    return (low + high) / 2;
}

Column makeRow(const AlbedoTableKey& key, std::size_t row) {
    const double phi = static_cast<double>(row) / (kSide - 1) * std::numbers::pi / 2;
    const glm::dvec2 alpha = key.alpha ? glm::dvec2(*key.alpha) : glm::dvec2(alphaOfRow(row));
    const glm::dvec2 azimuth = key.alpha ? glm::dvec2(std::cos(phi), std::sin(phi)) : glm::dvec2(1, 0);
    const facets::Facets facets{key.distribution, key.masking, alpha};
    Column column;
    for (std::size_t i = 0; i < kSide; ++i) {
        const double place = static_cast<double>(i) / (kSide - 1);
        const double cosine =
            std::max(cosineAt(place, glm::length(alpha * azimuth)), 1e-6 * std::min(alpha.x, alpha.y));
        column[i] = albedo(key, facets, glm::dvec3(std::sqrt(1 - cosine * cosine) * azimuth, cosine));
    }
    return column;
}

std::uint32_t quantised(double value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 65535));
}
std::uint32_t packed(const Albedo& a) { return quantised(std::sqrt(a.second)) | quantised(std::sqrt(a.lost)) << 16U; }

/// Means over uniform light of a quantised row as it is looked up.
struct Means {
    double second = 0, lost = 0;
    double place = 0;  ///< of lost times the x of its walk (facet_walk.h)

    Means& operator+=(const Means& other) {
        second += other.second;
        lost += other.lost;
        place += other.place;
        return *this;
    }
};

/// 2 ∫ E(μ) μ dμ. Steps crowd where grazing: μ = t⁴.
Means meansOf(const Column& column, double alpha, bool conductor) {
    constexpr int kSteps = 8192;
    Means sum;
    for (int s = 0; s < kSteps; ++s) {
        const double t = (s + 0.5) / kSteps, cosine = t * t * t * t;
        const double place = placeOf(cosine, alpha * std::sqrt(1 - cosine * cosine)) * (kSide - 1);
        const auto i = std::min(static_cast<std::size_t>(place), kSide - 2);
        const auto value = [&](std::size_t k) {
            const std::uint32_t word = packed(column[k]);
            return glm::dvec2(word & 0xffffU, word >> 16U) / 65535.0;
        };
        const glm::dvec2 v = glm::mix(value(i), value(i + 1), place - static_cast<double>(i));
        const glm::dvec2 part = v * v * (8 * cosine * t * t * t / kSteps);
        sum += {part.x, part.y, part.y * (conductor ? (1 - cosine) * (1 - cosine) : cosine * cosine * (2 - cosine))};
    }
    return sum;
}

/// The mean that is lost comes divided by alpha^2, to which it is about proportional.
std::uint32_t floatBits(double value) { return std::bit_cast<std::uint32_t>(static_cast<float>(value)); }

/// What the walk tells of one roughness. Conductors: the cosines and then the chances of leaving, at x = 0 and 1;
/// dielectrics: the share that is transmitted, and how it changes with x, over it.
glm::dvec4 walkAt(const AlbedoTableKey& key, double alpha) {
    if (key.eta != 0) {
        const facets::GlassWalk walk = facets::walkOnGlass(alpha, key.eta);
        return {walk.share, walk.share > 0 ? (walk.at.at1 - walk.at.at0) / walk.share : 0, 0, 0};
    }
    const facets::MetalWalk walk = facets::walkOnMetal(alpha);
    const auto cosine = [](double cube) { return 1 - std::cbrt(std::clamp(cube, 0.0, 1.0)); };
    const auto escape = [](double more) { return 1 / std::max(1.0, more); };
    return {cosine(walk.angle.at0), cosine(walk.angle.at1), escape(walk.more.at0), escape(walk.more.at1)};
}

/// walkAt every row: measured at some, with straight lines between.
std::array<glm::dvec4, kSide> walkRows(const AlbedoTableKey& key) {
    std::array<glm::dvec4, kSide> rows;
    if (key.alpha) {
        rows.fill(walkAt(key, std::sqrt(double{key.alpha->x} * double{key.alpha->y})));
        return rows;
    }
    constexpr std::size_t kStep = 4, kKnots = (kSide - 1 + kStep - 1) / kStep + 1;
    const auto rowOf = [](std::size_t knot) { return std::min(knot * kStep, kSide - 1); };
    std::array<glm::dvec4, kKnots> knots;
    tbb::parallel_for(std::size_t{0}, kKnots, [&](std::size_t k) { knots[k] = walkAt(key, alphaOfRow(rowOf(k))); });
    for (std::size_t row = 0; row < kSide; ++row) {
        const std::size_t k = std::min(row / kStep, kKnots - 2);
        const double from = static_cast<double>(rowOf(k)), to = static_cast<double>(rowOf(k + 1));
        rows[row] = glm::mix(knots[k], knots[k + 1], (static_cast<double>(row) - from) / (to - from));
    }
    return rows;
}

AlbedoCell walkCell(const AlbedoTableKey& key, const glm::dvec4& walk, double place) {
    if (key.eta != 0) return {floatBits(walk.x), floatBits(walk.y), floatBits(place), 0};
    const auto pair = [](double a, double b) { return quantised(a) | quantised(b) << 16U; };
    return {pair(walk.x, walk.y), pair(walk.z, walk.w), floatBits(place), 0};
}

}  // namespace

std::vector<AlbedoCell> makeAlbedoTable(const AlbedoTableKey& key) {
    std::array<Column, kSide> rows;
    tbb::parallel_for(std::size_t{0}, kSide, [&](std::size_t row) { rows[row] = makeRow(key, row); });
    std::array<Means, kSide> means;
    for (std::size_t row = 0; row < kSide; ++row) {
        const double phi = static_cast<double>(row) / (kSide - 1) * std::numbers::pi / 2;
        const double alpha = key.alpha ? glm::length(glm::dvec2(*key.alpha) * glm::dvec2(std::cos(phi), std::sin(phi)))
                                       : alphaOfRow(row);
        means[row] = meansOf(rows[row], alpha, key.eta == 0);
    }
    if (key.alpha) {  // the mean over all azimuths, for every row: by the trapezoidal rule
        Means sum;
        for (std::size_t row = 0; row + 1 < kSide; ++row)
            for (const Means& m : {means[row], means[row + 1]}) sum += {m.second / 2, m.lost / 2, m.place / 2};
        means.fill({sum.second / (kSide - 1), sum.lost / (kSide - 1), sum.place / (kSide - 1)});
    }
    const auto lost = [&](std::size_t row) {
        const double alpha2 = key.alpha ? key.alpha->x * key.alpha->y : std::pow(alphaOfRow(row), 2);
        return floatBits(means[row].lost / alpha2);
    };
    std::vector<AlbedoCell> cells;
    cells.reserve(kAlbedoTableWords);
    for (std::size_t j = 0; j + 1 < kSide; ++j)
        for (std::size_t i = 0; i + 1 < kSide; ++i)
            cells.push_back(
                {packed(rows[j][i]), packed(rows[j][i + 1]), packed(rows[j + 1][i]), packed(rows[j + 1][i + 1])});
    for (std::size_t j = 0; j + 1 < kSide; ++j)
        cells.push_back({lost(j), lost(j + 1), floatBits(means[j].second), floatBits(means[j + 1].second)});
    const std::array<glm::dvec4, kSide> walks = walkRows(key);
    for (std::size_t j = 0; j < kSide; ++j)
        cells.push_back(walkCell(key, walks[j], means[j].lost > 0 ? means[j].place / means[j].lost : 0));
    return cells;
}

}  // namespace vkpt
