// Jittered sampling [Cook 86]: of a dimension pair, one sample a cell of a grid, visited in random order.
#include "samplers/strata.glsl"

uvec2 jitteredPair(SampleId id, uint pair) {
    StrataGrid grid = strataGrid(id.spp);
    StrataCell cell = strataCell(grid, id, pair);
    return uvec2(placeInStratum(cell.column, grid.columns, id, 2u * pair),
                 placeInStratum(cell.row, grid.rows, id, 2u * pair + 1u));
}
