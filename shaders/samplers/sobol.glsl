// Sobol' sequence with the direction numbers of [Joe 08], Owen-scrambled by a hash. [Burley 20, Vegdahl 21]
// Tested: the bits equal the reference's; every elementary interval is hit once.

// Nested uniform scramble of a 32-bit fraction: bit k is flipped by a hash of the bits above it and the key.
uint owenScramble(uint x, uint key) {
    x = bitfieldReverse(x);
    x ^= x * 0x3d20adeau;
    x += key;
    x *= (key >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return bitfieldReverse(x);
}

// Four direction numbers a word, 8 words a dimension; only the digits that some index has are visited.
uint sobolPoint(uint index, uint dimension) {
    uint word = scene.samplerTable + dimension * 8u, x = 0u;
    for (uint digit = 0u; digit < kIndexDigits; ++digit, ++word, index >>= 4u) {
        uvec4 v = sceneWord(word) & (uvec4(0u) - (uvec4(index, index >> 1u, index >> 2u, index >> 3u) & 1u));
        x ^= v.x ^ v.y ^ v.z ^ v.w;
    }
    return x;
}

uint sobolBits(SampleId id, uint dim) {
    uint key = hash(hash(uvec4(id.pixel, dim, id.seed, kSaltOwen))).x;
    return owenScramble(sobolPoint(id.index, dim % kSobolDimensions), key);
}
