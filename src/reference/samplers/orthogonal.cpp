// Orthogonal arrays of strength 2, Bose's construction, sampled as in [Jarosz 19]: of any two dimensions of an array
// one sample a cell of the p x p grid, of every dimension one a row of p^2.
#include "reference/samplers/bits.h"
#include "reference/samplers/strata.h"

namespace vkpt::reference {

namespace {

/// The root of N, which is the square of a prime.
std::uint32_t levelsFor(std::uint32_t spp) {
    std::uint32_t p = 1;
    while ((p + 1) * (p + 1) <= std::min(spp, kLargestPrimeSet)) ++p;
    return p;
}

/// Row (a0, a1) of the array in column j. Any two columns hold every pair of levels once.
std::uint32_t boseLevel(std::uint32_t a0, std::uint32_t a1, std::uint32_t j, std::uint32_t p) {
    if (j == 0) return a0;
    if (j == 1) return a1;
    return (a0 + (j - 1) * a1) % p;
}

/// A random affine permutation of the levels: any two go to any two others alike.
std::uint32_t shuffleLevel(std::uint32_t level, std::uint32_t p, std::uint32_t key) {
    return ((1 + scaled(key * 0x9e3779b9U, p - 1)) * level + scaled(key, p)) % p;
}

}  // namespace

std::uint32_t orthogonalBits(SampleId id, std::uint32_t dim) {
    const std::uint32_t p = levelsFor(id.spp);
    const std::uint32_t columns = (p + 1) / 2 * 2;  // whole pairs
    const std::uint32_t j = dim % columns, partner = j ^ 1U;
    const auto [element, round] = elementOf(id.index, p * p);
    const glm::uvec4 key = samplerKey(id.pixel, dim / columns, id.seed, round);
    const std::uint32_t row = permute(element, p * p, key.x);
    const std::uint32_t stratum = shuffleLevel(boseLevel(row / p, row % p, j, p), p, subKey(key.y, j));
    const std::uint32_t substratum = shuffleLevel(boseLevel(row / p, row % p, partner, p), p, subKey(key.z, j));
    return placeInStratum(stratum * p + substratum, p * p, id, dim);
}

}  // namespace vkpt::reference
