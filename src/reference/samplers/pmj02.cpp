// Progressive multi-jittered (0,2) sequences [Christensen 18] from tables, Owen-scrambled.
#include "reference/sampler.h"
#include "reference/samplers/bits.h"
#include "scene/sampler_data.h"

namespace vkpt::reference {

namespace {

/// Numbers the pairs that paths use: all four of the camera, the first four of a bounce's eight.
std::uint32_t pairOrder(std::uint32_t pair) {
    return pair < 4 ? pair : 4 + (pair - 4) / 8 * 4 + (pair - 4) % 4;
}

}  // namespace

std::uint32_t pmj02Bits(SampleId id, std::uint32_t dim) {
    const std::uint32_t pair = dim / 2, copy = id.index / kPmj02Points;
    const std::uint32_t first = samplerKey(id.pixel, kNone, id.seed, copy).x;
    const std::size_t table = (first + pairOrder(pair)) % kPmj02Tables;
    const std::uint32_t point = pmj02Tables()[table * kPmj02Points + id.index % kPmj02Points];
    const glm::uvec4 key = samplerKey(id.pixel, pair, id.seed, copy);
    if (dim % 2 == 0) return owenScramble((point & 0xffffU) << 16U, key.x);
    return owenScramble((point >> 16U) << 16U, key.y);
}

}  // namespace vkpt::reference
