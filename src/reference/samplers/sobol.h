// Parts of the Sobol' sampler that tests check one by one.
#pragma once
#include <cstdint>

namespace vkpt::reference {

/// The unscrambled sequence: 32-bit fixed point of component `dim` (below kSobolDimensions) of point `index`.
[[nodiscard]] std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t dim);

/// Hash-based nested uniform (Owen) scramble. [Burley 20], constants of [Vegdahl 21].
[[nodiscard]] std::uint32_t owenScramble(std::uint32_t bits, std::uint32_t key);

}  // namespace vkpt::reference
