// Hammersley's set: i/N, then the dimensions of Halton's sequence. [Hammersley 60]
#include "reference/samplers/bits.h"
#include "reference/samplers/radical_inverse.h"

namespace vkpt::reference {

std::uint32_t hammersleyBits(SampleId id, std::uint32_t dim, ScrambleId scramble) {
    if (dim > 0) return haltonDimension(id, dim - 1, scramble);
    const auto bits = static_cast<std::uint32_t>((std::uint64_t{id.index % id.spp} << 32U) / id.spp);
    const std::uint32_t key = samplerKey(id.pixel, kNone, id.seed).x;
    if (scramble == ScrambleId::Owen) return owenScramble(bits, key);
    return scramble == ScrambleId::Digit ? bits ^ key : bits;
}

}  // namespace vkpt::reference
