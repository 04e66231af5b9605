// Exact sums of contributions in 96-bit fixed point. DESIGN, "The film is exact".
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "constants.h"
#include "layout.h"

namespace vkpt::reference {

/// Contributions from here on are refused: 2^40 nits.
inline constexpr float kContributionLimit = 0x1p40F;

/// floor(value x 2^48 + 1/2) as three little-endian words. Requires 0 <= value < 2^40.
[[nodiscard]] inline std::array<std::uint32_t, 3> toFixedPoint(float value) {
    static_assert(kFilmFractionBits == 48);
    const double v = value;  // every step below is exact: a float has 24 significant bits
    const double top = std::floor(v * 0x1p-16);
    const double middle = std::floor((v - top * 0x1p16) * 0x1p16);
    const double low = std::floor(((v - top * 0x1p16) * 0x1p16 - middle) * 0x1p32 + 0.5);
    const auto carried = (static_cast<std::uint64_t>(middle) << 32U) + static_cast<std::uint64_t>(low);
    return {static_cast<std::uint32_t>(carried), static_cast<std::uint32_t>(carried >> 32U),
            static_cast<std::uint32_t>(top)};
}

/// Adds three words to the low three of `sum`.
inline void addFixedPoint(uvec4& sum, const std::array<std::uint32_t, 3>& words) {
    std::uint64_t carry = 0;
    for (int i = 0; i < 3; ++i) {
        carry += std::uint64_t{sum[i]} + words[static_cast<std::size_t>(i)];
        sum[i] = static_cast<std::uint32_t>(carry);
        carry >>= 32U;
    }
}

/// Adds one contribution in nits, rounded once. Refuses it whole, returning false, where a channel is NaN, negative
/// or not below kContributionLimit.
[[nodiscard]] inline bool addContribution(FilmSums& sums, const vec3& contribution) {
    for (int i = 0; i < 3; ++i) {
        if (!(contribution[i] >= 0 && contribution[i] < kContributionLimit)) return false;
    }
    addFixedPoint(sums.red, toFixedPoint(contribution.x));
    addFixedPoint(sums.green, toFixedPoint(contribution.y));
    addFixedPoint(sums.blue, toFixedPoint(contribution.z));
    return true;
}

}  // namespace vkpt::reference
