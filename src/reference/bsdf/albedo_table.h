// Tables of how much a microsurface reflects, by angle and roughness. estimator.md, Microfacets; layout.h, AlbedoCell.
#pragma once
#include <algorithm>

#include "constants.h"
#include "layout.h"
#include "reference/real.h"

namespace vkpt::reference {

/// View of the kAlbedoTableWords cells of one table, or of none.
struct AlbedoTable {
    const AlbedoCell* cells = nullptr;

    [[nodiscard]] bool exists() const { return cells != nullptr; }
    /// (first, second) towards a direction of |cosine|, at row y in [0, kAlbedoSide - 1].
    template <class Real>
    [[nodiscard]] Vec2<Real> albedo(Real cosine, Real y) const;
    /// Means over the hemisphere, weighted by the cosine.
    template <class Real>
    [[nodiscard]] Vec2<Real> mean(Real y) const;
};

/// (first, second) of one word.
template <class Real>
[[nodiscard]] Vec2<Real> unpackAlbedo(std::uint32_t word) {
    return Vec2<Real>(word & 0xffffU, word >> 16U) / Real(65535);
}

/// Place in [0, kAlbedoSide - 1] along an axis: the corner before it, and how far it is to the next.
template <class Real>
struct TablePlace {
    std::uint32_t cell;
    Real fraction;

    explicit TablePlace(Real place)
        : cell(std::min(static_cast<std::uint32_t>(place), kAlbedoSide - 2)), fraction(place - Real(cell)) {}
};

template <class Real>
Vec2<Real> AlbedoTable::albedo(Real cosine, Real y) const {
    const TablePlace<Real> i(Real(kAlbedoSide - 1) * std::sqrt(std::min(Real(1), std::abs(cosine)))), j(y);
    const AlbedoCell& cell = cells[j.cell * (kAlbedoSide - 1) + i.cell];
    const auto row = [&](std::uint32_t a, std::uint32_t b) {
        return glm::mix(unpackAlbedo<Real>(a), unpackAlbedo<Real>(b), i.fraction);
    };
    return glm::mix(row(cell.x, cell.y), row(cell.z, cell.w), j.fraction);
}

template <class Real>
Vec2<Real> AlbedoTable::mean(Real y) const {
    const TablePlace<Real> j(y);
    const AlbedoCell& cell = cells[(kAlbedoSide - 1) * (kAlbedoSide - 1) + j.cell];
    return glm::mix(unpackAlbedo<Real>(cell.x), unpackAlbedo<Real>(cell.y), j.fraction);
}

}  // namespace vkpt::reference
