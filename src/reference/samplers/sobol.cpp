// Sobol' sequence with the direction numbers of [Joe 08], Owen-scrambled per pixel, dimension and seed.
#include "reference/samplers/sobol.h"

#include <bit>
#include <vector>

#include "reference/sampler.h"
#include "scene/sobol_directions.h"

namespace vkpt::reference {

namespace {

std::uint32_t reverseBits(std::uint32_t x) {
    x = (x >> 16U) | (x << 16U);
    x = ((x & 0xff00ff00U) >> 8U) | ((x & 0x00ff00ffU) << 8U);
    x = ((x & 0xf0f0f0f0U) >> 4U) | ((x & 0x0f0f0f0fU) << 4U);
    x = ((x & 0xccccccccU) >> 2U) | ((x & 0x33333333U) << 2U);
    return ((x & 0xaaaaaaaaU) >> 1U) | ((x & 0x55555555U) << 1U);
}

}  // namespace

std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t dim) {
    static const std::vector<std::uint32_t> directions = sobolDirections();
    const std::uint32_t* column = directions.data() + std::size_t{dim} * 32;
    std::uint32_t bits = 0;
    for (std::uint32_t rest = index; rest != 0; rest &= rest - 1) bits ^= column[std::countr_zero(rest)];
    return bits;
}

std::uint32_t owenScramble(std::uint32_t bits, std::uint32_t key) {
    std::uint32_t x = reverseBits(bits);
    x ^= x * 0x3d20adeaU;
    x += key;
    x *= (key >> 16U) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return reverseBits(x);
}

std::uint32_t sobolBits(SampleId id, std::uint32_t dim) {
    const std::uint32_t key = hash(hash({id.pixel, dim, id.seed, kSaltOwen})).x;
    return owenScramble(sobolPoint(id.index, dim % kSobolDimensions), key);
}

}  // namespace vkpt::reference
