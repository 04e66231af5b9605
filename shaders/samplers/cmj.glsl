// Correlated multi-jittered sampling [Kensler 13]: multi-jittered, with one shuffle for all columns and one for all
// rows, which spreads the samples of neighbouring cells.
#include "samplers/strata.glsl"

uvec2 cmjPair(SampleId id, uint pair) {
    StrataGrid grid = strataGrid(id.spp);
    StrataCell cell = strataCell(grid, id, pair);
    uint x = cell.column * grid.rows.d + permute(cell.row, grid.rows, cell.key.y);
    uint y = cell.row * grid.columns.d + permute(cell.column, grid.columns, cell.key.z);
    return uvec2(placeInStratum(x, grid.count, id, 2u * pair), placeInStratum(y, grid.count, id, 2u * pair + 1u));
}
