// Quotients of the film's integers, rounded once.
#pragma once
#include <cstdint>

#include "film/wide_integer.h"

namespace vkpt {

/// numerator / (denominator x 2^fractionBits), rounded once, to nearest even. Requires denominator > 0 and
/// fractionBits <= 48.
[[nodiscard]] float exactRatio(U128 numerator, std::uint32_t denominator, std::uint32_t fractionBits);

}  // namespace vkpt
