// Dithered sampling [Georgiev 16]: one padded (0,2)-sequence for all pixels, shifted in each by a blue-noise mask.
#include "reference/sampler.h"
#include "reference/samplers/net02.h"
#include "scene/sampler_data.h"

namespace vkpt::reference {

std::uint32_t bluenoiseBits(SampleId id, std::uint32_t dim) {
    const std::uint32_t point = scrambledNet02(id.index, dim % 2, samplerKey(kNone, dim / 2, id.seed));
    const std::uint32_t offset = samplerKey(kNone, dim, id.seed, 1).x;  // every dimension sees the mask elsewhere
    const std::uint32_t column = ((id.pixel & 0xffffU) + (offset & 0xffffU)) % kMaskSide;
    const std::uint32_t row = ((id.pixel >> 16U) + (offset >> 16U)) % kMaskSide;
    const std::uint32_t rank = blueNoiseMask()[std::size_t{row} * kMaskSide + column];
    return point + (rank << 18U | samplerKey(id.pixel, dim, id.seed).x >> 14U);
}

}  // namespace vkpt::reference
