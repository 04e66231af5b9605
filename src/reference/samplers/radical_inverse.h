// Radical inverses in prime bases. estimator.md, Samplers, halton.
#pragma once
#include <cstdint>

#include "reference/sampler.h"

namespace vkpt::reference {

/// Faure's permutation of the digits of base `base`, at `digit`, by its recursive definition. [Faure 92]
[[nodiscard]] std::uint32_t faureDigit(std::uint32_t digit, std::uint32_t base);

/// Inverse of `index` in `base`, 32-bit fixed point of 24 bits' worth of digits. `key` names the scramble.
[[nodiscard]] std::uint32_t radicalInverse(std::uint32_t index, std::uint32_t base, ScrambleId scramble,
                                           std::uint32_t key);

/// Dimension `dim` of Halton's sequence.
[[nodiscard]] std::uint32_t haltonDimension(SampleId id, std::uint32_t dim, ScrambleId scramble);

}  // namespace vkpt::reference
