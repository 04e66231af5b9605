// Data of samplers: what tools/sampler_tables makes at build time, and published constants.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "constants.h"

namespace vkpt {

/// kPmj02Tables sequences of kPmj02Points points, x | y << 16, both 16-bit fractions.
[[nodiscard]] std::span<const std::uint32_t> pmj02Tables();

/// kMaskSide^2 ranks, row by row: a permutation of 0 … kMaskSide^2 - 1.
[[nodiscard]] std::span<const std::uint16_t> blueNoiseMask();

/// Generating vector of an embedded lattice rule in base 2 with up to 2^20 points, order-2 weights. [Cools 06]
extern const std::array<std::uint32_t, kRank1Dimensions> kRank1Generator;

}  // namespace vkpt
