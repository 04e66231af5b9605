#include "reference/samplers/strata.h"

#include <algorithm>
#include <bit>

namespace vkpt::reference {

std::uint32_t permute(std::uint32_t j, std::uint32_t n, std::uint32_t p) {
    const std::uint32_t mask = n == 1 ? 0 : ~0U >> std::countl_zero(n - 1);
    do {
        j ^= p;
        j *= 0xe170893dU;
        j ^= p >> 16U;
        j ^= (j & mask) >> 4U;
        j ^= p >> 8U;
        j *= 0x0929eb3fU;
        j ^= p >> 23U;
        j ^= (j & mask) >> 1U;
        j *= 1U | p >> 27U;
        j *= 0x6935fa69U;
        j ^= (j & mask) >> 11U;
        j *= 0x74dcb303U;
        j ^= (j & mask) >> 2U;
        j *= 0x9e501cc3U;
        j ^= (j & mask) >> 2U;
        j *= 0xc860a3dfU;
        j &= mask;
        j ^= j >> 5U;
    } while (j >= n);
    return (j + p) % n;
}

std::uint32_t placeInStratum(std::uint32_t c, std::uint32_t n, SampleId id, std::uint32_t dim) {
    const std::uint32_t jitter = hash({id.pixel, id.index, dim, id.seed}).x;
    return static_cast<std::uint32_t>((std::uint64_t{c} << 32U | jitter) / n);
}

StrataGrid::StrataGrid(std::uint32_t spp) {
    const std::uint32_t samples = std::min(spp, kLargestSet);
    columns = 1;
    while ((columns + 1) * (columns + 1) <= samples) ++columns;
    rows = (samples + columns - 1) / columns;
}

}  // namespace vkpt::reference
