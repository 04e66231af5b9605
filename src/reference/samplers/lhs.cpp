// Latin hypercube sampling (N-rooks): of every dimension, one sample a row. [McKay 79, Shirley 91]
#include "reference/samplers/bits.h"
#include "reference/samplers/strata.h"

namespace vkpt::reference {

std::uint32_t lhsBits(SampleId id, std::uint32_t dim) {
    const std::uint32_t rows = std::min(id.spp, kLargestSet);
    const auto [element, round] = elementOf(id.index, rows);
    return placeInStratum(permute(element, rows, samplerKey(id.pixel, dim, id.seed, round).x), rows, id, dim);
}

}  // namespace vkpt::reference
