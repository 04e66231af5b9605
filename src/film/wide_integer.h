// The film's wide integers on the host.
#pragma once
#include <bit>
#include <cstdint>

#include "layout.h"

namespace vkpt {

__extension__ using U128 = unsigned __int128;

/// x, y and z as one number of 96 bits.
[[nodiscard]] inline U128 sumOf(const uvec4& word) { return U128{word.x} | U128{word.y} << 32U | U128{word.z} << 64U; }

/// All four words as one number.
[[nodiscard]] inline U128 wideSumOf(const uvec4& word) { return sumOf(word) | U128{word.w} << 96U; }

/// A number of 96 bits in two's complement, as sign and magnitude.
struct SignedSum {
    bool negative;
    U128 magnitude;
};
[[nodiscard]] inline SignedSum signedSumOf(const uvec4& word) {
    const U128 bits = sumOf(word);
    const bool negative = word.z >> 31U != 0;
    return {negative, negative ? (U128{1} << 96U) - bits : bits};
}

[[nodiscard]] inline int leadingZeros(U128 value) {
    const auto high = static_cast<std::uint64_t>(value >> 64U), low = static_cast<std::uint64_t>(value);
    return high != 0 ? std::countl_zero(high) : 64 + std::countl_zero(low);
}

}  // namespace vkpt
