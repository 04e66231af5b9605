// Tables of how much a microsurface reflects, by angle and roughness. estimator.md, Microfacets; layout.h, AlbedoCell.
#pragma once
#include <algorithm>
#include <bit>

#include "constants.h"
#include "layout.h"
#include "reference/real.h"

namespace vkpt::reference {

/// Where a direction is looked up: both in [0, 1].
template <class Real>
struct TablePlace {
    Real column, row;
};

template <class Real>
struct Albedo {
    Real second, lost;

    [[nodiscard]] Real first() const { return std::max(Real(0), 1 - second - lost); }
};

/// What a random walk tells of light that more than one facet meets, at one roughness. estimator.md, Interreflection.
template <class Real>
struct MetalWalk {
    Vec2<Real> cosine{1};  ///< where Fresnel's term stands for all facets: of light along the normal, of grazing light
    Vec2<Real> escape{1};  ///< chance to leave after a further facet: of the same two
    Real place = 0;        ///< mean of what runs from the former to the latter
};
template <class Real>
struct GlassWalk {
    Real share = 0;  ///< of it that is transmitted
    Real slope = 0;  ///< of that share over c^2 (2 - c), c the cosine, relative
    Real place = 0;  ///< mean of c^2 (2 - c)
};

/// View of the kAlbedoTableWords cells of one table, or of none.
struct AlbedoTable {
    const AlbedoCell* cells = nullptr;

    [[nodiscard]] bool exists() const { return cells != nullptr; }
    template <class Real>
    [[nodiscard]] Albedo<Real> albedo(const TablePlace<Real>& place) const;
    /// Means over the hemisphere, weighted by the cosine, at the roughness alpha.
    template <class Real>
    [[nodiscard]] Albedo<Real> mean(Real row, Real alpha) const;
    /// Of a table of a conductor.
    template <class Real>
    [[nodiscard]] MetalWalk<Real> metalWalk(Real row) const;
    /// Of a table of a dielectric.
    template <class Real>
    [[nodiscard]] GlassWalk<Real> glassWalk(Real row) const;

    static constexpr std::uint32_t kMeans = (kAlbedoSide - 1) * (kAlbedoSide - 1), kWalks = kMeans + kAlbedoSide - 1;
};

template <class Real>
[[nodiscard]] Vec2<Real> unpackPair(std::uint32_t word) {
    return Vec2<Real>(word & 0xffffU, word >> 16U) / Real(65535);
}
template <class Real>
[[nodiscard]] Real unpackFloat(std::uint32_t word) {
    return Real(std::bit_cast<float>(word));
}

/// A place along an axis: the corner before it, and how far it is to the next.
template <class Real>
struct TableStep {
    std::uint32_t cell;
    Real fraction;

    explicit TableStep(Real place) {
        const Real scaled = place * Real(kAlbedoSide - 1);
        cell = std::min(static_cast<std::uint32_t>(scaled), kAlbedoSide - 2);
        fraction = scaled - Real(cell);
    }
};

template <class Real>
Albedo<Real> AlbedoTable::albedo(const TablePlace<Real>& place) const {
    const TableStep<Real> i(place.column), j(place.row);
    const AlbedoCell& cell = cells[j.cell * (kAlbedoSide - 1) + i.cell];
    const auto row = [&](std::uint32_t a, std::uint32_t b) {
        return glm::mix(unpackPair<Real>(a), unpackPair<Real>(b), i.fraction);
    };
    const Vec2<Real> v = glm::mix(row(cell.x, cell.y), row(cell.z, cell.w), j.fraction);
    return {v.x * v.x, v.y * v.y};
}

template <class Real>
Albedo<Real> AlbedoTable::mean(Real row, Real alpha) const {
    const TableStep<Real> j(row);
    const AlbedoCell& cell = cells[kMeans + j.cell];
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
        return glm::mix(unpackFloat<Real>(a), unpackFloat<Real>(b), j.fraction);
    };
    return {between(cell.z, cell.w), alpha * alpha * between(cell.x, cell.y)};
}

template <class Real>
MetalWalk<Real> AlbedoTable::metalWalk(Real row) const {
    const TableStep<Real> j(row);
    const AlbedoCell &a = cells[kWalks + j.cell], &b = cells[kWalks + j.cell + 1];
    const auto pair = [&](std::uint32_t u, std::uint32_t v) {
        return glm::mix(unpackPair<Real>(u), unpackPair<Real>(v), j.fraction);
    };
    return {pair(a.x, b.x), pair(a.y, b.y), glm::mix(unpackFloat<Real>(a.z), unpackFloat<Real>(b.z), j.fraction)};
}

template <class Real>
GlassWalk<Real> AlbedoTable::glassWalk(Real row) const {
    const TableStep<Real> j(row);
    const AlbedoCell &a = cells[kWalks + j.cell], &b = cells[kWalks + j.cell + 1];
    const auto between = [&](std::uint32_t u, std::uint32_t v) {
        return glm::mix(unpackFloat<Real>(u), unpackFloat<Real>(v), j.fraction);
    };
    return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)};
}

}  // namespace vkpt::reference
