#include "analysis/bsdf_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/sphere_quadrature.h"
#include "reference/hash.h"

namespace vkpt {

namespace {

using reference::BsdfSample;

struct Draw {
    double uLobe;
    glm::dvec2 u;
};

Draw randomDraw(std::uint32_t index, std::uint32_t seed) {
    const glm::uvec4 h = reference::hash(reference::hash({index, seed, 0xb5df, 0}));
    return {reference::toUnit(h.x), {reference::toUnit(h.y), reference::toUnit(h.z)}};
}

bool transmits(const BsdfDouble& b) { return b.model == BsdfId::Dielectric; }

/// Radiance to flux.
double fluxScale(const BsdfDouble& b, const glm::dvec3& wi) { return wi.z < 0 ? b.eta.x * b.eta.x : 1; }

/// Where lobes are narrow.
std::vector<glm::dvec3> peaksOf(const BsdfDouble& b, const glm::dvec3& wo) {
    std::vector<glm::dvec3> peaks{reference::mirrored(wo)};
    if (transmits(b) && reference::dielectricFresnel(wo.z, b.eta.x) < 1)
        peaks.push_back(reference::refractThrough(wo, glm::dvec3(0, 0, 1), b.eta.x));
    if (transmits(b)) peaks.push_back(-wo);  // facets that face wo; with an ior near 1 they hardly deflect
    return peaks;
}

/// Halvings after which a cell is as small as the narrowest lobe, or as what Fresnel and masking do at grazing angles.
int peakDepth(const BsdfDouble& b, const glm::dvec3& wo) {
    double width = 1;
    const bool facets =
        b.model != BsdfId::Phong && b.model != BsdfId::BlinnPhong && b.model != BsdfId::AshikhminShirley;
    if (facets)
        width = std::max(std::min(b.alphaX, b.alphaY), 1e-4);
    else
        width = 1 / std::sqrt(1 + std::max(b.exponentX, b.exponentY));
    if (transmits(b)) width *= std::min(1.0, std::abs(b.eta.x - 1));
    width = std::min(width, 2 * wo.z);
    return std::clamp(static_cast<int>(std::ceil(-std::log2(width))) + 2, 3, 18);
}

}  // namespace

BsdfIntegrals integrateBsdf(const BsdfDouble& b, const glm::dvec3& wo) {
    BsdfIntegrals sum;
    const DirectionFunction f = [&](const glm::dvec3& wi) {
        const double scale = fluxScale(b, wi) * std::abs(wi.z);
        return glm::dvec4(scale * reference::evalBsdf(b, wo, wi), reference::pdfBsdf(b, wo, wi));
    };
    const auto peaks = peaksOf(b, wo);
    const QuadratureConfig config{.leastDepth = 4, .peakDepth = peakDepth(b, wo)};
    for (const bool upper : {true, false}) {
        if (!upper && !transmits(b)) continue;
        const glm::dvec4 part = integrate(f, {.upper = upper}, peaks, config);
        (upper ? sum.reflected : sum.transmitted) = glm::dvec3(part);
        sum.pdf += part.w;
    }
    // Delta lobes come one a choice: draws at these places meet every one of them.
    double share = 0;
    constexpr int kPlaces = 4096;
    glm::dvec3 reflected(0), through(0);
    for (int i = 0; i < kPlaces; ++i) {
        const auto s = reference::sampleBsdf(b, wo, (i + 0.5) / kPlaces, glm::dvec2(0.5));
        if (!std::isinf(s.pdf)) {
            if (i == 0 && !reference::hasDensity(b, wo)) break;
            continue;
        }
        share += 1.0 / kPlaces;
        (s.wi.z > 0 ? reflected : through) += s.weight * (fluxScale(b, s.wi) / kPlaces);
    }
    sum.reflected += reflected;
    sum.transmitted += through;
    return sum;
}

BsdfDraws drawBsdf(const BsdfDouble& b, const glm::dvec3& wo, std::uint32_t count, std::uint32_t seed) {
    BsdfDraws draws;
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Draw draw = randomDraw(i, seed);
        const BsdfSample<double> s = reference::sampleBsdf(b, wo, draw.uLobe, draw.u);
        if (s.pdf == 0) draws.invalid += 1.0 / count;
        if (std::isinf(s.pdf)) draws.delta += 1.0 / count;
        const glm::dvec3 weight = s.weight * fluxScale(b, s.wi);
        const double size = reference::luminance(weight);
        draws.mean += weight / static_cast<double>(count);
        draws.largest = std::max(draws.largest, size);
        sum += size;
        squares += size * size;
    }
    const double mean = sum / count;
    if (mean > 0) draws.relativeVariance = std::max(0.0, squares / count / (mean * mean) - 1);
    return draws;
}

TestResult testBsdfDraws(const BsdfDouble& b, const BsdfDouble& claimed, const glm::dvec3& wo, std::uint32_t count,
                         std::uint32_t seed) {
    constexpr std::size_t kSide = 24, kCells = kSide * kSide;
    std::vector<double> seen(2 * kCells), expected(2 * kCells);
    double drawn = 0, total = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Draw draw = randomDraw(i, seed);
        const auto s = reference::sampleBsdf(b, wo, draw.uLobe, draw.u);
        if (s.pdf == 0 || std::isinf(s.pdf)) continue;
        const glm::dvec2 place = squareOfDirection(s.wi) * static_cast<double>(kSide);
        const auto x = std::min(kSide - 1, static_cast<std::size_t>(place.x));
        const auto y = std::min(kSide - 1, static_cast<std::size_t>(place.y));
        seen[(s.wi.z > 0 ? 0 : kCells) + y * kSide + x] += 1;
        drawn += 1;
    }
    const DirectionFunction density = [&](const glm::dvec3& wi) {
        return glm::dvec4(reference::pdfBsdf(claimed, wo, wi), 0, 0, 0);
    };
    const auto peaks = peaksOf(b, wo);
    const QuadratureConfig config{.tolerance = 1e-6, .leastDepth = 0, .peakDepth = peakDepth(b, wo)};
    const QuadratureConfig closer{.tolerance = 1e-6, .leastDepth = 7, .peakDepth = peakDepth(b, wo)};
    for (std::size_t i = 0; i < (transmits(b) ? 2 * kCells : kCells); ++i) {
        const SphereCell cell{i < kCells, static_cast<double>(i % kSide) / kSide,
                              static_cast<double>(i % kCells / kSide) / kSide, 1.0 / kSide};
        expected[i] = integrate(density, cell, peaks, config).x;
        // The corner that a lobe with an edge has in a cell may lie between all places of the rule.
        if (expected[i] == 0 && seen[i] > 0) expected[i] = integrate(density, cell, peaks, closer).x;
        total += expected[i];
    }
    for (double& e : expected) e *= total > 0 ? drawn / total : 0;
    return chiSquareTest(seen, expected);
}

double reciprocityError(const BsdfDouble& b, const BsdfDouble& back, std::uint32_t pairs, std::uint32_t seed) {
    double worst = 0;
    const auto direction = [](const glm::dvec2& u, bool upper) { return directionOfSquare(u, upper); };
    for (std::uint32_t i = 0; i < pairs; ++i) {
        const glm::uvec4 h = reference::hash(reference::hash({i, seed, 0x2ec1, 0}));
        const bool through = transmits(b) && i % 2 == 1;
        const glm::dvec3 wo = direction({reference::toUnit(h.x), reference::toUnit(h.y)}, true);
        const glm::dvec3 wi = direction({reference::toUnit(h.z), reference::toUnit(h.w)}, !through);
        const glm::dvec3 there = reference::evalBsdf(b, wo, wi) * (through ? b.eta.x : 1.0);
        const glm::dvec3 turned(1, 1, through ? -1 : 1);  // the frame of the other side
        const BsdfDouble& other = through ? back : b;
        const glm::dvec3 here = reference::evalBsdf(other, wi * turned, wo * turned) * (through ? other.eta.x : 1.0);
        for (int c = 0; c < 3; ++c) {
            const double sum = there[c] + here[c];
            if (sum > 1e-12) worst = std::max(worst, std::abs(there[c] - here[c]) / sum);
        }
    }
    return worst;
}

}  // namespace vkpt
