// Orthogonal arrays of strength 2 by Bose's construction, as [Jarosz 19, listing 1] sample them: p^2 samples, of any
// two of an array's p + 1 dimensions one a cell of the p x p grid, of every dimension one a row of p^2.
#include "samplers/strata.glsl"

// Level of row (a0, a1) in a column of the array.
uint boseLevel(uvec2 a, uint column, Divisor p) {
    return column == 0u ? a.x : (column == 1u ? a.y : divide(a.x + (column - 1u) * a.y, p).y);
}

// A random permutation of the levels, one of the affine maps modulo p: any two levels go to any two others alike.
uint shuffleLevel(uint level, Divisor p, uint key) {
    return divide((1u + multiplyHigh(key * 0x9e3779b9u, p.d - 1u)) * level + multiplyHigh(key, p.d), p).y;
}

uvec2 orthogonalPair(SampleId id, uint pair) {
    Divisor p = makeDivisor(integerRoot(min(id.spp, kLargestPrimeSet))), count = makeDivisor(p.d * p.d);
    uvec2 array = divide(pair, makeDivisor((p.d + 1u) >> 1u));  // which array; which of its pairs of columns
    uvec2 set = divide(id.index, count);
    uvec4 key = samplerKey(id.pixel, array.x, id.seed, set.x);
    uvec2 row = divide(permute(set.y, count, key.x), p);
    uint column = 2u * array.y, a = boseLevel(row, column, p), b = boseLevel(row, column + 1u, p);
    uint x = shuffleLevel(a, p, subKey(key.y, column)) * p.d + shuffleLevel(b, p, subKey(key.z, column));
    uint y = shuffleLevel(b, p, subKey(key.y, column + 1u)) * p.d + shuffleLevel(a, p, subKey(key.z, column + 1u));
    return uvec2(placeInStratum(x, count, id, 2u * pair), placeInStratum(y, count, id, 2u * pair + 1u));
}
