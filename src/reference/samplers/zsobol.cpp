// Blue-noise error by hierarchical ordering of pixels [Ahmed 20]: one (0,2)-sequence along a Z curve over the screen,
// whose quadtree is shuffled node by node.
#include <algorithm>
#include <array>
#include <bit>

#include "reference/sampler.h"
#include "reference/samplers/net02.h"

namespace vkpt::reference {

namespace {

/// The permutations of {0, 1, 2, 3} that fix 0; xor with a number below 4 makes all 24 of them.
constexpr std::array<std::array<std::uint32_t, 4>, 6> kFixingZero{
    {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 1, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 3, 2, 1}}};

/// Bits of x and y in turn, x in the lowest.
std::uint64_t mortonCode(std::uint32_t x, std::uint32_t y, std::uint32_t bits) {
    std::uint64_t code = 0;
    for (std::uint32_t k = 0; k < bits; ++k) code |= std::uint64_t{(x >> k & 1U) | (y >> k & 1U) << 1U} << (2 * k);
    return code;
}

/// Permutes the base-4 digits of a number of `bits` bits from the top, each by a hash of `root` and of those above it,
/// which follow a 1: numbers of different length differ.
std::uint32_t shuffleDigits(std::uint64_t number, std::uint32_t bits, std::uint32_t root) {
    const std::uint64_t marked = 1ULL << bits | number;
    std::uint64_t shuffled = 0;
    for (std::uint32_t left = bits; left > 0;) {
        const std::uint32_t node = mixBits(root ^ static_cast<std::uint32_t>(marked >> left));
        if (left == 1) {
            shuffled = shuffled * 2 + ((number ^ node) & 1U);
            left = 0;
        } else {
            left -= 2;
            const std::uint64_t digit = number >> left & 3U;
            shuffled = shuffled * 4 + (kFixingZero[scaled(node, 6)][digit] ^ node % 4);
        }
    }
    return static_cast<std::uint32_t>(shuffled);
}

}  // namespace

std::uint32_t zsobolBits(SampleId id, std::uint32_t dim) {
    const auto sampleBits = static_cast<std::uint32_t>(std::bit_width(id.spp - 1));
    const std::uint32_t level = std::min(kZCurveLevels, (32 - sampleBits) / 2);
    const std::uint32_t x = id.pixel & 0xffffU, y = id.pixel >> 16U, pair = dim / 2;
    const std::uint64_t inPixel = id.index & ((1ULL << sampleBits) - 1);
    const std::uint64_t number = mortonCode(x, y, level) << sampleBits | inPixel;
    const auto round = static_cast<std::uint32_t>(std::uint64_t{id.index} >> sampleBits);
    const std::uint32_t root = samplerKey(x >> level | (y >> level) << 16U, pair, id.seed, round).x;
    const glm::uvec4 key = samplerKey(kNone, pair, id.seed);
    const std::uint32_t point = net02Point(shuffleDigits(number, 2 * level + sampleBits, root), dim % 2);
    return owenScramble(point, dim % 2 == 0 ? key.x : key.y);
}

}  // namespace vkpt::reference
