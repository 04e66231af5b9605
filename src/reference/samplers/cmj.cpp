// Correlated multi-jittered sampling [Kensler 13]: multi-jittered, all columns shuffled alike, and all rows.
#include "reference/samplers/bits.h"
#include "reference/samplers/strata.h"

namespace vkpt::reference {

std::uint32_t cmjBits(SampleId id, std::uint32_t dim) {
    const StrataGrid grid(id.spp);
    const auto [element, round] = elementOf(id.index, grid.size());
    const glm::uvec4 key = samplerKey(id.pixel, dim / 2, id.seed, round);
    const std::uint32_t cell = permute(element, grid.size(), key.x);
    const std::uint32_t column = cell % grid.columns, row = cell / grid.columns;
    const std::uint32_t fine = dim % 2 == 0 ? column * grid.rows + permute(row, grid.rows, key.y)
                                            : row * grid.columns + permute(column, grid.columns, key.z);
    return placeInStratum(fine, grid.size(), id, dim);
}

}  // namespace vkpt::reference
