// Multi-jittered sampling [Chiu 94]: of a dimension pair, one sample a cell of a grid, one a row and one a column of
// the fine grid. Within each column of cells the samples are shuffled anew, and within each row.
#include "samplers/strata.glsl"

uvec2 multijitteredPair(SampleId id, uint pair) {
    StrataGrid grid = strataGrid(id.spp);
    StrataCell cell = strataCell(grid, id, pair);
    uint x = cell.column * grid.rows.d + permute(cell.row, grid.rows, subKey(cell.key.y, cell.column));
    uint y = cell.row * grid.columns.d + permute(cell.column, grid.columns, subKey(cell.key.z, cell.row));
    return uvec2(placeInStratum(x, grid.count, id, 2u * pair), placeInStratum(y, grid.count, id, 2u * pair + 1u));
}
