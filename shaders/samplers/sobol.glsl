// Sobol' sequence with the direction numbers of [Joe 08].
// Table: 32 direction numbers a dimension, four a word.
#include "samplers/bits.glsl"

// Only the digits of the index that some index has are visited.
uint sobolPoint(uint index, uint dimension) {
    uint word = scene.samplerTable + dimension * 8u, x = 0u;
    for (uint digit = 0u; digit < kIndexDigits; ++digit, ++word, index >>= 4u) {
        uvec4 v = sceneWord(word) & (uvec4(0u) - (uvec4(index, index >> 1u, index >> 2u, index >> 3u) & 1u));
        x ^= v.x ^ v.y ^ v.z ^ v.w;
    }
    return x;
}

uint sobolBits(SampleId id, uint dim) {
    uint point = sobolPoint(id.index, dim % kSobolDimensions);
    if (kScramble == kScrambleOwen) return owenScramble(point, samplerKey(id.pixel, dim, id.seed, 0u).x);
    if (kScramble == kScrambleXor) return point ^ samplerKey(id.pixel, dim, id.seed, 0u).x;
    return dim < kSobolDimensions ? point : point ^ samplerKey(0u, dim, 0u, 0u).x;
}
