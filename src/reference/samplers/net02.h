// The (0,2)-sequence in base 2 behind sobol02, zsobol and bluenoise.
#pragma once
#include "reference/samplers/bits.h"

namespace vkpt::reference {

/// Coordinate `axis` (0 or 1) of point `index`: the van der Corput sequence, and Sobol's second dimension. [Sobol 67]
[[nodiscard]] inline std::uint32_t net02Point(std::uint32_t index, std::uint32_t axis) {
    if (axis == 0) return reverseBits(index);
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 1U << 31U; index != 0; index >>= 1U, direction ^= direction >> 1U)
        if ((index & 1U) != 0) bits ^= direction;
    return bits;
}

/// The sequence with its order shuffled by key.x, its coordinates scrambled by key.y and key.z.
[[nodiscard]] inline std::uint32_t scrambledNet02(std::uint32_t index, std::uint32_t axis, const glm::uvec4& key) {
    return owenScramble(net02Point(owenScramble(index, key.x), axis), key[1 + static_cast<int>(axis)]);
}

}  // namespace vkpt::reference
