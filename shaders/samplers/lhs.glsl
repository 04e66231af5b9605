// Latin hypercube (N-rooks): of every dimension, one sample a row. [McKay 79, Shirley 91]
#include "samplers/strata.glsl"

uint lhsBits(SampleId id, uint dim) {
    Divisor rows = makeDivisor(min(id.spp, kLargestSet));
    uvec2 set = divide(id.index, rows);
    uint row = permute(set.y, rows, samplerKey(id.pixel, dim, id.seed, set.x).x);
    return placeInStratum(row, rows, id, dim);
}
