// The part of the Sobol' sampler that tests check by itself.
#pragma once
#include <cstdint>

namespace vkpt::reference {

/// The unscrambled sequence: 32-bit fixed point of component `dim` (below kSobolDimensions) of point `index`.
[[nodiscard]] std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t dim);

}  // namespace vkpt::reference
