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

/// View of the kAlbedoTableWords cells of one table, or of none.
struct AlbedoTable {
    const AlbedoCell* cells = nullptr;

    [[nodiscard]] bool exists() const { return cells != nullptr; }
    template <class Real>
    [[nodiscard]] Albedo<Real> albedo(const TablePlace<Real>& place) const;
    /// Means over the hemisphere, weighted by the cosine, at the roughness alpha.
    template <class Real>
    [[nodiscard]] Albedo<Real> mean(Real row, Real alpha) const;
};

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
    const auto unpack = [](std::uint32_t word) { return Vec2<Real>(word & 0xffffU, word >> 16U) / Real(65535); };
    const auto row = [&](std::uint32_t a, std::uint32_t b) { return glm::mix(unpack(a), unpack(b), i.fraction); };
    const Vec2<Real> v = glm::mix(row(cell.x, cell.y), row(cell.z, cell.w), j.fraction);
    return {v.x * v.x, v.y * v.y};
}

template <class Real>
Albedo<Real> AlbedoTable::mean(Real row, Real alpha) const {
    const TableStep<Real> j(row);
    const AlbedoCell& cell = cells[(kAlbedoSide - 1) * (kAlbedoSide - 1) + j.cell];
    const auto number = [](std::uint32_t word) { return Real(std::bit_cast<float>(word)); };
    return {glm::mix(number(cell.z), number(cell.w), j.fraction),
            alpha * alpha * glm::mix(number(cell.x), number(cell.y), j.fraction)};
}

}  // namespace vkpt::reference
