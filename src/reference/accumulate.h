// Exact sums of contributions in 96-bit fixed point. DESIGN, "The film is exact".
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "constants.h"
#include "layout.h"

namespace vkpt::reference {

__extension__ using U128 = unsigned __int128;

/// Contributions from here on are refused: 2^40 nits.
inline constexpr float kContributionLimit = 0x1p40F;
/// Values of layers are refused from this magnitude on.
inline constexpr float kLayerLimit = 0x1p31F;
static_assert(kFilmLimitBits == 40 && kLayerLimitBits == 31);

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

[[nodiscard]] inline std::array<std::uint32_t, 3> wordsOf(U128 value) {
    return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32U),
            static_cast<std::uint32_t>(value >> 64U)};
}

/// The magnitude as above, in two's complement of 96 bits: addFixedPoint adds it like any other.
[[nodiscard]] inline std::array<std::uint32_t, 3> toSignedFixedPoint(float value) {
    const auto words = toFixedPoint(std::abs(value));
    if (!(value < 0)) return words;
    return wordsOf(-(U128{words[2]} << 64U | U128{words[1]} << 32U | U128{words[0]}));
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

/// Adds sums and counts of one path to those of its pixel.
inline void addSums(FilmSums& pixel, const FilmSums& path) {
    const auto add = [](uvec4& into, const uvec4& word) {
        addFixedPoint(into, {word.x, word.y, word.z});
        into.w += word.w;
    };
    add(pixel.red, path.red);
    add(pixel.green, path.green);
    add(pixel.blue, path.blue);
}

/// Adds one contribution in nits, rounded once. Refuses it whole, returning false, where the magnitude of a channel is
/// NaN or not below kContributionLimit; or where it is below 0, unless `mayTakeAway`, as some pixel filters do.
[[nodiscard]] inline bool addContribution(FilmSums& sums, const vec3& contribution, bool mayTakeAway) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(contribution[i]) < kContributionLimit) || (contribution[i] < 0 && !mayTakeAway)) return false;
    }
    addFixedPoint(sums.red, toSignedFixedPoint(contribution.x));
    addFixedPoint(sums.green, toSignedFixedPoint(contribution.y));
    addFixedPoint(sums.blue, toSignedFixedPoint(contribution.z));
    return true;
}

/// Luminance of a path, 24 bits of fraction, rounded; nothing where a channel is below 0 or not below 2^32 nits.
[[nodiscard]] inline std::optional<std::uint64_t> pathLuminance(const FilmSums& path) {
    constexpr std::uint32_t kCut = kFilmFractionBits - kLuminanceFractionBits;
    const auto cut = [](const uvec4& sum) { return (U128{sum.z} << 64U | U128{sum.y} << 32U | U128{sum.x}) >> kCut; };
    const U128 red = cut(path.red), green = cut(path.green), blue = cut(path.blue);
    const U128 limit = U128{1} << (kLuminanceLimitBits + kLuminanceFractionBits);
    if (red >= limit || green >= limit || blue >= limit) return std::nullopt;
    const U128 weighted = red * kLuminanceRed + green * kLuminanceGreen + blue * kLuminanceBlue;
    return static_cast<std::uint64_t>((weighted + (1U << 15U)) >> 16U);
}

/// Adds luminance^2 to a sum of 128 bits.
inline void addSquare(uvec4& sum, std::uint64_t luminance) {
    U128 total = U128{sum.w} << 96U | U128{sum.z} << 64U | U128{sum.y} << 32U | U128{sum.x};
    total += U128{luminance} * luminance;
    const auto low = wordsOf(total);
    sum = uvec4(low[0], low[1], low[2], static_cast<std::uint32_t>(total >> 96U));
}

}  // namespace vkpt::reference
