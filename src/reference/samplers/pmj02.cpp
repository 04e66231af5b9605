// Progressive multi-jittered (0,2) sequences [Christensen 18] from tables, shuffled and Owen-scrambled.
#include <bit>

#include "reference/sampler.h"
#include "reference/samplers/bits.h"
#include "scene/sampler_data.h"

namespace vkpt::reference {

namespace {

/// Shuffles each [2^k, 2^(k+1)) within itself, aligned blocks staying together, so that every first 2^k points remain
/// what they are while the orders of two pairs have nothing in common.
std::uint32_t shuffleProgressively(std::uint32_t index, std::uint32_t key) {
    if (index < 2) return index;
    const std::uint32_t highest = std::bit_floor(index);
    const int shift = std::countl_zero(index) + 1;
    return highest | owenScramble(index << shift, key) >> shift;
}

}  // namespace

std::uint32_t pmj02Bits(SampleId id, std::uint32_t dim) {
    const std::uint32_t pair = dim / 2, copy = id.index / kPmj02Points;
    const std::uint32_t first = samplerKey(id.pixel, kNone, id.seed, copy).x;
    const std::size_t table = (first + pair) % kPmj02Tables;
    const glm::uvec4 key = samplerKey(id.pixel, pair, id.seed, copy);
    const std::uint32_t element = shuffleProgressively(id.index % kPmj02Points, key.z);
    const std::uint32_t point = pmj02Tables()[table * kPmj02Points + element];
    if (dim % 2 == 0) return owenScramble((point & 0xffffU) << 16U, key.x);
    return owenScramble((point >> 16U) << 16U, key.y);
}

}  // namespace vkpt::reference
