#include "film/exact_ratio.h"

#include <cmath>

namespace vkpt {

/// The quotient of integers is cut to 32 bits with every lost bit kept as a sticky one; 32 > 24 + 2, so the
/// conversion to float rounds as the exact quotient would. No result is subnormal: the least is 2^-80.
float exactRatio(U128 numerator, std::uint32_t denominator, std::uint32_t fractionBits) {
    if (numerator == 0) return 0.0F;
    const int normalise = leadingZeros(numerator);
    const U128 shifted = numerator << static_cast<unsigned>(normalise);
    const U128 quotient = shifted / denominator;
    const int cut = 96 - leadingZeros(quotient);  // at least 64: the quotient has 96 bits or more
    const bool lost =
        quotient * denominator != shifted || (quotient & ((U128{1} << static_cast<unsigned>(cut)) - 1)) != 0;
    const auto top = static_cast<std::uint32_t>(quotient >> static_cast<unsigned>(cut)) | (lost ? 1U : 0U);
    return std::ldexp(static_cast<float>(top), cut - normalise - static_cast<int>(fractionBits));
}

}  // namespace vkpt
