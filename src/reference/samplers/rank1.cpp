// Extensible rank-1 lattice [Hickernell 00], generating vector of [Cools 06], randomly shifted.
#include "reference/sampler.h"
#include "reference/samplers/bits.h"
#include "scene/sampler_data.h"

namespace vkpt::reference {

std::uint32_t rank1Bits(SampleId id, std::uint32_t dim) {
    return reverseBits(id.index) * kRank1Generator[dim % kRank1Dimensions] + samplerKey(id.pixel, dim, id.seed).x;
}

}  // namespace vkpt::reference
