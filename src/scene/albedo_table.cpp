#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/albedo_tables.h"
#include "scene/facets.h"

namespace vkpt {
namespace {

constexpr std::size_t kSide = kAlbedoSide;
using Column = std::array<glm::dvec2, kSide>;  ///< (first, second) at each cosine of one row

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

glm::dvec2 albedo(const AlbedoTableKey& key, const facets::Facets& facets, const glm::dvec3& wo) {
    constexpr int kSteps = 48;
    const facets::Facets ggx{Distribution::Ggx, key.masking, facets.alpha};
    const double ggxG1 = 1 / (1 + ggx.lambda(wo));
    glm::dvec2 sum(0);
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const auto wm = visibleNormal(wo, facets.alpha, (i + 0.5) / kSteps, (j + 0.5) / kSteps);
            const double cosine = glm::dot(wo, wm);
            if (cosine <= 0) continue;
            const double density = facets.d(wm) / (ggx.d(wm) * ggxG1);
            const glm::dvec2 share = ofFacet(cosine, key.eta);
            const glm::dvec3 reflected = 2 * cosine * wm - wo;
            if (reflected.z > 0) {
                const double weight = density * facets.g2(wo, reflected);
                sum += key.eta == 0 ? weight * share : glm::dvec2(weight * share.x, 0);
            }
            if (key.eta == 0 || share.y == 0) continue;
            const double cosT = std::sqrt(1 - (1 - cosine * cosine) / (key.eta * key.eta));
            const glm::dvec3 transmitted = (cosine / key.eta - cosT) * wm - wo / static_cast<double>(key.eta);
            if (transmitted.z < 0) sum.y += density * facets.g2(wo, transmitted) * share.y;
        }
    }
    return sum / double{kSteps * kSteps};
}

Column makeRow(const AlbedoTableKey& key, std::size_t row) {
    const double place = static_cast<double>(row) / (kSide - 1);
    const double alpha = place * place, phi = place * std::numbers::pi / 2;
    const facets::Facets facets{key.distribution, key.masking, key.alpha ? glm::dvec2(*key.alpha) : glm::dvec2(alpha)};
    Column column;
    for (std::size_t i = 0; i < kSide; ++i) {
        const double x = static_cast<double>(i) / (kSide - 1), cosine = std::max(x * x, 1e-6);
        const double sine = std::sqrt(1 - cosine * cosine);
        const glm::dvec3 wo =
            key.alpha ? glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine) : glm::dvec3(sine, 0, cosine);
        const bool smooth = !key.alpha && row == 0;
        column[i] = smooth ? ofFacet(cosine, key.eta) : albedo(key, facets, wo);
        column[i] /=
            std::max(1.0, column[i].x + column[i].y);  // phong, for want of its own masking, gains at grazing angles
    }
    return column;
}

std::uint32_t quantised(double value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 65535));
}
std::uint32_t packed(const glm::dvec2& pair) { return quantised(pair.x) | quantised(pair.y) << 16U; }
glm::dvec2 unpacked(std::uint32_t word) { return glm::dvec2(word & 0xffffU, word >> 16U) / 65535.0; }

/// 2 ∫ E(μ) μ dμ of the quantised row, linear in x = sqrt μ between its places: 4 ∫ E(x) x^3 dx.
glm::dvec2 meanOf(const Column& column) {
    glm::dvec2 sum(0);
    for (std::size_t i = 0; i + 1 < kSide; ++i) {
        const double a = static_cast<double>(i) / (kSide - 1), b = static_cast<double>(i + 1) / (kSide - 1);
        const glm::dvec2 ea = unpacked(packed(column[i])), eb = unpacked(packed(column[i + 1]));
        const glm::dvec2 slope = (eb - ea) / (b - a), constant = ea - slope * a;
        sum += constant * (std::pow(b, 4) - std::pow(a, 4)) + slope * (std::pow(b, 5) - std::pow(a, 5)) * 0.8;
    }
    return sum;
}

}  // namespace

std::vector<AlbedoCell> makeAlbedoTable(const AlbedoTableKey& key) {
    std::array<Column, kSide> rows;
    tbb::parallel_for(std::size_t{0}, kSide, [&](std::size_t row) { rows[row] = makeRow(key, row); });
    std::array<glm::dvec2, kSide> means;
    std::ranges::transform(rows, means.begin(), meanOf);
    if (key.alpha) {  // the mean over all azimuths, for every row
        glm::dvec2 sum = (means.front() + means.back()) / 2.0;
        for (std::size_t row = 1; row + 1 < kSide; ++row) sum += means[row];
        means.fill(sum / double{kSide - 1});
    }
    std::vector<AlbedoCell> cells;
    cells.reserve(kAlbedoTableWords);
    for (std::size_t j = 0; j + 1 < kSide; ++j)
        for (std::size_t i = 0; i + 1 < kSide; ++i)
            cells.push_back(
                {packed(rows[j][i]), packed(rows[j][i + 1]), packed(rows[j + 1][i]), packed(rows[j + 1][i + 1])});
    for (std::size_t j = 0; j + 1 < kSide; ++j) cells.push_back({packed(means[j]), packed(means[j + 1]), 0, 0});
    return cells;
}

}  // namespace vkpt
