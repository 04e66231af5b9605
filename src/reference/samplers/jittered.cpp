// Jittered sampling [Cook 86]: of a dimension pair, one sample a cell of a grid.
#include "reference/samplers/bits.h"
#include "reference/samplers/strata.h"

namespace vkpt::reference {

std::uint32_t jitteredBits(SampleId id, std::uint32_t dim) {
    const StrataGrid grid(id.spp);
    const auto [element, round] = elementOf(id.index, grid.size());
    const std::uint32_t cell = permute(element, grid.size(), samplerKey(id.pixel, dim / 2, id.seed, round).x);
    if (dim % 2 == 0) return placeInStratum(cell % grid.columns, grid.columns, id, dim);
    return placeInStratum(cell / grid.columns, grid.rows, id, dim);
}

}  // namespace vkpt::reference
