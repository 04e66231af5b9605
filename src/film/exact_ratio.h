// Quotients of the film's integers, rounded once.
#pragma once
#include <cstdint>

#include "film/wide_integer.h"

namespace vkpt {

/// numerator / (denominator x 2^fractionBits), rounded once, to nearest even. Requires denominator > 0 and
/// fractionBits <= 48.
[[nodiscard]] float exactRatio(U128 numerator, std::uint32_t denominator, std::uint32_t fractionBits);
[[nodiscard]] inline float exactRatio(const SignedSum& numerator, std::uint32_t denominator,
                                      std::uint32_t fractionBits) {
    const float ratio = exactRatio(numerator.magnitude, denominator, fractionBits);
    return numerator.negative ? -ratio : ratio;
}

}  // namespace vkpt
