// Permutations and strata of finite point sets. estimator.md, Samplers.
#pragma once
#include <cstdint>

#include "reference/sampler.h"

namespace vkpt::reference {

/// Element j of pseudo-random permutation p of 0 … n-1. [Kensler 13]
[[nodiscard]] std::uint32_t permute(std::uint32_t j, std::uint32_t n, std::uint32_t p);

/// The place of sample `id` in stratum `c` of n equal ones, in dimension `dim`.
[[nodiscard]] std::uint32_t placeInStratum(std::uint32_t c, std::uint32_t n, SampleId id, std::uint32_t dim);

/// A sample as an element of one of the finite sets that its index runs through.
struct SetElement {
    std::uint32_t element, round;
};
[[nodiscard]] inline SetElement elementOf(std::uint32_t index, std::uint32_t size) {
    return {index % size, index / size};
}

/// The grid of strata for spp samples: columns x rows >= min(spp, kLargestSet).
struct StrataGrid {
    explicit StrataGrid(std::uint32_t spp);
    std::uint32_t columns, rows;
    [[nodiscard]] std::uint32_t size() const { return columns * rows; }
};

}  // namespace vkpt::reference
