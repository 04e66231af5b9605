// Multi-jittered sampling [Chiu 94]: jittered, and of both dimensions one sample a row of the N fine ones; the fine
// rows are shuffled anew within every column and row of cells.
#include "reference/samplers/bits.h"
#include "reference/samplers/strata.h"

namespace vkpt::reference {

std::uint32_t multijitteredBits(SampleId id, std::uint32_t dim) {
    const StrataGrid grid(id.spp);
    const auto [element, round] = elementOf(id.index, grid.size());
    const glm::uvec4 key = samplerKey(id.pixel, dim / 2, id.seed, round);
    const std::uint32_t cell = permute(element, grid.size(), key.x);
    const std::uint32_t column = cell % grid.columns, row = cell / grid.columns;
    if (dim % 2 == 0) {
        const std::uint32_t ofColumn = subKey(key.y, column);
        return placeInStratum(column * grid.rows + permute(row, grid.rows, ofColumn), grid.size(), id, dim);
    }
    const std::uint32_t ofRow = subKey(key.z, row);
    return placeInStratum(row * grid.columns + permute(column, grid.columns, ofRow), grid.size(), id, dim);
}

}  // namespace vkpt::reference
