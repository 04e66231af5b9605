// Sobol' sequence with the direction numbers of [Joe 08].
#include "reference/samplers/sobol.h"

#include <bit>
#include <vector>

#include "reference/sampler.h"
#include "reference/samplers/bits.h"
#include "scene/sobol_directions.h"

namespace vkpt::reference {

std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t dim) {
    static const std::vector<std::uint32_t> directions = sobolDirections();
    const std::uint32_t* column = directions.data() + std::size_t{dim} * 32;
    std::uint32_t bits = 0;
    for (std::uint32_t rest = index; rest != 0; rest &= rest - 1) bits ^= column[std::countr_zero(rest)];
    return bits;
}

std::uint32_t sobolBits(SampleId id, std::uint32_t dim, ScrambleId scramble) {
    const std::uint32_t point = sobolPoint(id.index, dim % kSobolDimensions);
    const std::uint32_t key = samplerKey(id.pixel, dim, id.seed).x;
    switch (scramble) {
        case ScrambleId::Owen:
            return owenScramble(point, key);
        case ScrambleId::Xor:
            return point ^ key;
        default:
            return dim < kSobolDimensions ? point : point ^ samplerKey(0, dim, 0).x;
    }
}

}  // namespace vkpt::reference
