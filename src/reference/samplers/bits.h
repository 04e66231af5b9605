// What several samplers are made of: keys, and scrambles in base 2. estimator.md, Samplers.
#pragma once
#include <bit>
#include <cstdint>

#include "constants.h"
#include "reference/hash.h"

namespace vkpt::reference {

/// [Wellons 18]
[[nodiscard]] inline std::uint32_t mixBits(std::uint32_t x) {
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    return x ^ (x >> 16U);
}

/// The n-th of the keys that one key stands for.
[[nodiscard]] inline std::uint32_t subKey(std::uint32_t key, std::uint32_t n) { return mixBits(key + n * 0x9e3779b9U); }

/// Four words that name one unit `d` (a dimension, a pair, an array) of one pixel, in copy `round` of a finite set.
[[nodiscard]] inline glm::uvec4 samplerKey(std::uint32_t pixel, std::uint32_t d, std::uint32_t seed,
                                           std::uint32_t round = 0) {
    const glm::uvec4 k = hash(hash({pixel, round, seed, kSaltSampler}));
    return {subKey(k.x, d), subKey(k.y, d), subKey(k.z, d), subKey(k.w, d)};
}

/// A uniform number below n from uniform bits.
[[nodiscard]] inline std::uint32_t scaled(std::uint32_t bits, std::uint32_t n) {
    return static_cast<std::uint32_t>(std::uint64_t{bits} * n >> 32U);
}

[[nodiscard]] inline std::uint32_t reverseBits(std::uint32_t x) {
    x = (x >> 16U) | (x << 16U);
    x = ((x & 0xff00ff00U) >> 8U) | ((x & 0x00ff00ffU) << 8U);
    x = ((x & 0xf0f0f0f0U) >> 4U) | ((x & 0x0f0f0f0fU) << 4U);
    x = ((x & 0xccccccccU) >> 2U) | ((x & 0x33333333U) << 2U);
    return ((x & 0xaaaaaaaaU) >> 1U) | ((x & 0x55555555U) << 1U);
}

/// Hash-based nested uniform (Owen) scramble of a fraction, or shuffle of an index. [Burley 20, Vegdahl 21]
[[nodiscard]] inline std::uint32_t owenScramble(std::uint32_t bits, std::uint32_t key) {
    std::uint32_t x = reverseBits(bits);
    x ^= x * 0x3d20adeaU;
    x += key;
    x *= (key >> 16U) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return reverseBits(x);
}

}  // namespace vkpt::reference
