// Extensible rank-1 lattice [Hickernell 00], generating vector of [Cools 06], with a random shift.
// Table: the generating vector, four components a word.
#include "samplers/bits.glsl"

uint rank1Bits(SampleId id, uint dim) {
    uint d = dim % kRank1Dimensions;
    uint z = sceneWord(scene.samplerTable + (d >> 2u))[d & 3u];
    return bitfieldReverse(id.index) * z + samplerKey(id.pixel, dim, id.seed, 0u).x;
}
