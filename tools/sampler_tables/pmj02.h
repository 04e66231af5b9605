// Progressive multi-jittered (0,2) sequences.
#pragma once
#include <cstdint>
#include <random>
#include <vector>

namespace vkpt {

struct Point16 {
    std::uint32_t x = 0, y = 0;  ///< 16-bit fractions
};

/// 4^log4Count points, at most 4^8, of which every first 2^k fill each elementary interval of area 2^-k once.
/// [Christensen 18], with strata drawn from the free ones as [Pharr 19] does.
[[nodiscard]] std::vector<Point16> makePmj02(unsigned log4Count, std::mt19937& random);

}  // namespace vkpt
