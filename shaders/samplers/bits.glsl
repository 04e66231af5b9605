// What several samplers are made of: keys, scrambles in base 2.
#ifndef VKPT_SAMPLERS_BITS
#define VKPT_SAMPLERS_BITS

// One word to one word. [Wellons 18]
uint mixBits(uint x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

// The n-th of many keys that one key stands for.
uint subKey(uint key, uint n) { return mixBits(key + n * 0x9e3779b9u); }

// Four independent words for unit `d` (a dimension, a pair, an array) of one pixel. Two rounds of the hash, which is
// the same for all units: the low bits of one are weak, and scrambles put them first. `round`: which copy of a set.
uvec4 samplerKey(uint pixel, uint d, uint seed, uint round) {
    uvec4 k = hash(hash(uvec4(pixel, round, seed, kSaltSampler)));
    return uvec4(subKey(k.x, d), subKey(k.y, d), subKey(k.z, d), subKey(k.w, d));
}

// Nested uniform scramble of a 32-bit fraction: bit k is flipped by a hash of the bits above it and the key.
// Of an index it is a shuffle that keeps every aligned block of 2^k together. [Burley 20, Vegdahl 21]
uint owenScramble(uint x, uint key) {
    x = bitfieldReverse(x);
    x ^= x * 0x3d20adeau;
    x += key;
    x *= (key >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return bitfieldReverse(x);
}
#endif
