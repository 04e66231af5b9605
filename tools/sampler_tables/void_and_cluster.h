// Blue-noise dither masks.
#pragma once
#include <cstdint>
#include <random>
#include <vector>

namespace vkpt {

/// Ranks 0 to side^2 - 1 on a torus: the cells of rank below any n are spread evenly, without low frequencies. By
/// voids and clusters of a Gaussian of standard deviation 1.5. [Ulichney 93]
[[nodiscard]] std::vector<std::uint32_t> makeVoidAndCluster(std::uint32_t side, std::mt19937& random);

}  // namespace vkpt
