// Albedo tables against a quadrature that shares nothing with theirs: over incident directions, not normals.
#include "scene/albedo_tables.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "scene/facets.h"

namespace vkpt {
namespace {

constexpr std::size_t kSide = kAlbedoSide;

/// The column or row that lies this far along a side.
std::size_t placeOf(double share) { return static_cast<std::size_t>(std::lround(share * (kSide - 1))); }

/// (first, second) of a corner, which holds the roots of second and of what both lack to 1.
glm::dvec2 unpack(std::uint32_t word) {
    const glm::dvec2 v = glm::dvec2(word & 0xffffU, word >> 16U) / 65535.0;
    return {1 - v.y * v.y - v.x * v.x, v.x * v.x};
}

double alphaOf(std::size_t row) { return std::pow(0.1 + 0.9 * static_cast<double>(row) / (kSide - 1), 4); }

/// Where a cosine lies among the columns; spread is alpha times the sine.
double columnOf(double cosine, double spread) {
    return (std::sqrt(cosine) + std::sqrt(std::sqrt(cosine / (cosine + spread)))) / 2 * (kSide - 1);
}

double cosineOf(std::size_t column, double alpha) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double c = (low + high) / 2;
        (columnOf(c, alpha * std::sqrt(1 - c * c)) < static_cast<double>(column) ? low : high) = c;
    }
    return low;
}

/// (first, second) of a table at one of its places.
glm::dvec2 at(std::span<const AlbedoCell> table, std::size_t i, std::size_t j) {
    const std::size_t ci = std::min(i, kSide - 2), cj = std::min(j, kSide - 2);
    const AlbedoCell& cell = table[cj * (kSide - 1) + ci];
    const std::uint32_t corners[4] = {cell.x, cell.y, cell.z, cell.w};
    return unpack(corners[(i - ci) + 2 * (j - cj)]);
}

/// Reflected share of a dielectric or of a mirror (eta 0) by midpoints over the hemisphere of wi.
double reflected(const facets::Facets& f, const glm::dvec3& wo, double eta) {
    constexpr int kCos = 400, kPhi = 400;
    double sum = 0;
    for (int i = 0; i < kCos; ++i) {
        for (int j = 0; j < kPhi; ++j) {
            const double c = (i + 0.5) / kCos, phi = 2 * std::numbers::pi * (j + 0.5) / kPhi, s = std::sqrt(1 - c * c);
            const glm::dvec3 wi(s * std::cos(phi), s * std::sin(phi), c), wm = glm::normalize(wo + wi);
            const double fresnel = eta == 0 ? 1 : facets::dielectric(glm::dot(wo, wm), eta);
            sum += fresnel * f.d(wm) * f.g2(wo, wi) / (4 * wo.z);
        }
    }
    return sum * 2 * std::numbers::pi / (double{kCos} * kPhi);
}

glm::dvec3 direction(double cosine, double phi = 0) {
    const double s = std::sqrt(1 - cosine * cosine);
    return {s * std::cos(phi), s * std::sin(phi), cosine};
}

TEST(AlbedoTable, HoldsTheAlbedoOfRoughMirrors) {
    for (const Distribution d : {Distribution::Ggx, Distribution::Beckmann, Distribution::Phong}) {
        const auto table = makeAlbedoTable({.distribution = d});
        ASSERT_EQ(table.size(), std::size_t{kAlbedoTableWords});
        for (const std::size_t i : {placeOf(0.4), placeOf(0.75), placeOf(1)}) {
            for (const std::size_t j : {placeOf(0.75), placeOf(1)}) {
                const double alpha = alphaOf(j);
                const facets::Facets f{.distribution = d, .alpha = glm::dvec2(alpha)};
                const glm::dvec2 e = at(table, i, j);
                EXPECT_NEAR(e.x + e.y, std::min(1.0, reflected(f, direction(cosineOf(i, alpha)), 0)), 1.5e-3)
                    << "distribution " << static_cast<int>(d) << " place " << i << ", " << j;
            }
        }
    }
}

TEST(AlbedoTable, SplitsByFresnelAtSmoothSurfaces) {
    const auto table = gltfAlbedoTable();
    ASSERT_EQ(table.size(), std::size_t{kAlbedoTableWords});
    for (std::size_t i = 1; i < kSide; ++i) {
        const double cosine = cosineOf(i, kDeltaAlpha), rest = std::pow(1 - cosine, 5);
        if (cosine < 0.01) continue;  // where facets hide each other, however small alpha
        EXPECT_NEAR(at(table, i, 0).x, 1 - rest, 5e-5);
        EXPECT_NEAR(at(table, i, 0).y, rest, 5e-5);
    }
}

TEST(AlbedoTable, HoldsWhatDielectricsReflectFromBothSides) {
    for (const float eta : {1.5F, 1 / 1.5F}) {
        const auto table = makeAlbedoTable({.eta = eta});
        for (const std::size_t i : {placeOf(0.5), placeOf(0.8)}) {
            const std::size_t j = placeOf(0.8);
            const facets::Facets f{.alpha = glm::dvec2(alphaOf(j))};
            const glm::dvec2 e = at(table, i, j);
            EXPECT_NEAR(e.x, reflected(f, direction(cosineOf(i, alphaOf(j))), eta), 2e-3) << eta << " place " << i;
            EXPECT_LE(e.x + e.y, 1 + 1e-4);
            EXPECT_GT(e.x + e.y, 0.6);
        }
    }
}

TEST(AlbedoTable, AnisotropicRowsAreAzimuths) {
    const glm::vec2 alpha(0.1F, 0.6F);
    const auto table = makeAlbedoTable({.alpha = alpha});
    const facets::Facets f{.alpha = glm::dvec2(alpha)};
    const std::size_t i = placeOf(0.6);
    for (const std::size_t j : {placeOf(0), placeOf(0.4), placeOf(1)}) {
        const double phi = static_cast<double>(j) / (kSide - 1) * std::numbers::pi / 2;
        const glm::dvec2 e = at(table, i, j);
        const double spread = std::hypot(alpha.x * std::cos(phi), alpha.y * std::sin(phi));
        EXPECT_NEAR(e.x + e.y, reflected(f, direction(cosineOf(i, spread), phi), 0), 2e-3) << "azimuth " << phi;
    }
}

TEST(AlbedoTable, MeansAreThoseOfTheInterpolatedTable) {
    const auto table = gltfAlbedoTable();
    for (const std::size_t j : {placeOf(0.1), placeOf(0.55), kSide - 2}) {
        const double alpha = alphaOf(j);
        glm::dvec2 sum(0);
        constexpr int kSteps = 20000;
        for (int s = 0; s < kSteps; ++s) {
            const double t = (s + 0.5) / kSteps, cosine = t * t * t, sine = std::sqrt(1 - cosine * cosine);
            const double place = columnOf(cosine, alpha * sine);
            const auto i = std::min(static_cast<std::size_t>(place), kSide - 2);
            const AlbedoCell& cell = table[j * (kSide - 1) + i];
            const auto corner = [](std::uint32_t word) { return glm::dvec2(word & 0xffffU, word >> 16U) / 65535.0; };
            const glm::dvec2 v = glm::mix(corner(cell.x), corner(cell.y), place - static_cast<double>(i));
            sum += v * v * (6 * cosine * t * t / kSteps);
        }
        const AlbedoCell& mean = table[(kSide - 1) * (kSide - 1) + j];
        EXPECT_NEAR(double{std::bit_cast<float>(mean.z)}, sum.x, 1e-5);
        EXPECT_NEAR(double{std::bit_cast<float>(mean.x)}, sum.y / (alpha * alpha), 1e-3);
    }
}

TEST(AlbedoTables, AreMadeOnceEachAndOnlyWhereNeeded) {
    const auto record = [](BsdfId model) { return bsdfRecord(defaultBsdf(model)); };
    AlbedoTables off(false);
    BsdfRecord conductor = record(BsdfId::Conductor), plastic = record(BsdfId::Plastic);
    off.add(BsdfId::Conductor, false, conductor);
    EXPECT_EQ(conductor.table, kNone);
    off.add(BsdfId::Plastic, false, plastic);
    EXPECT_EQ(plastic.table, 0U);
    BsdfRecord again = record(BsdfId::Plastic);
    off.add(BsdfId::Plastic, false, again);
    EXPECT_EQ(again.table, 0U);
    EXPECT_EQ(off.take().size(), std::size_t{2} * kAlbedoTableWords);

    AlbedoTables on(true);
    on.add(BsdfId::Conductor, false, conductor);
    EXPECT_EQ(conductor.table, 0U) << "glTF's own";
    BsdfRecord brushed = record(BsdfId::Conductor);
    brushed.alphaX = 0.5F;
    on.add(BsdfId::Conductor, false, brushed);
    EXPECT_EQ(brushed.table, std::uint32_t{kAlbedoTableWords});
    EXPECT_NE(brushed.flags & kBsdfAzimuthTable, 0U);
    EXPECT_EQ(on.take().size(), std::size_t{2} * kAlbedoTableWords);
}

}  // namespace
}  // namespace vkpt
