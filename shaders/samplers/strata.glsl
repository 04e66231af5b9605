// Permutations and strata of finite sets. Sets hold at most 2^16 samples, so that 32 bits suffice here.
#ifndef VKPT_SAMPLERS_STRATA
#define VKPT_SAMPLERS_STRATA
#include "samplers/bits.glsl"
#include "samplers/random.glsl"

// Element i of pseudo-random permutation p of 0 .. length.d - 1, by cycle walking. [Kensler 13, listing 3] There is
// nothing to walk where the length is a power of two: the loop goes if the length is known to the compiler.
uint permute(uint i, Divisor length, uint p) {
    uint w = length.d - 1u;
    w |= w >> 1u;
    w |= w >> 2u;
    w |= w >> 4u;
    w |= w >> 8u;
    w |= w >> 16u;
    do {
        i = (i ^ p) * 0xe170893du;
        i ^= p >> 16u;
        i ^= (i & w) >> 4u;
        i = (i ^ (p >> 8u)) * 0x0929eb3fu;
        i ^= p >> 23u;
        i = (i ^ ((i & w) >> 1u)) * (1u | (p >> 27u)) * 0x6935fa69u;
        i = (i ^ ((i & w) >> 11u)) * 0x74dcb303u;
        i = (i ^ ((i & w) >> 2u)) * 0x9e501cc3u;
        i = (i ^ ((i & w) >> 2u)) * 0xc860a3dfu;
        i &= w;
        i ^= i >> 5u;
    } while (length.d <= w && i >= length.d);
    return divide(i + p, length).y;
}

// floor((stratum 2^32 + jitter) / count): where sample `id` lies along `dim` in one of `count` equal parts of [0,1).
uint placeInStratum(uint stratum, Divisor count, SampleId id, uint dim) {
    uint jitter = randomBits(id, dim);
    uvec2 upper = divide((stratum << 16u) | (jitter >> 16u), count);
    return (upper.x << 16u) | divide((upper.y << 16u) | (jitter & 0xffffu), count).x;
}

uint integerRoot(uint n) {
    uint root = uint(sqrt(float(n)));
    root -= root * root > n ? 1u : 0u;
    return root + ((root + 1u) * (root + 1u) <= n ? 1u : 0u);
}

// The grid of strata of a set that is meant to hold spp samples.
struct StrataGrid {
    Divisor columns, rows, count;  // count = columns rows >= min(spp, kLargestSet)
};

StrataGrid strataGrid(uint spp) {
    uint samples = min(spp, kLargestSet), columns = integerRoot(samples), rows = (samples + columns - 1u) / columns;
    return StrataGrid(makeDivisor(columns), makeDivisor(rows), makeDivisor(columns * rows));
}

// A sample of a set that is laid out on a grid: its cell, and the keys of its dimension pair.
struct StrataCell {
    uint column, row;
    uvec4 key;
};

StrataCell strataCell(StrataGrid grid, SampleId id, uint pair) {
    uvec2 set = divide(id.index, grid.count);  // which set; which of its samples
    uvec4 key = samplerKey(id.pixel, pair, id.seed, set.x);
    uvec2 cell = divide(permute(set.y, grid.count, key.x), grid.columns);
    return StrataCell(cell.y, cell.x, key);
}
#endif
