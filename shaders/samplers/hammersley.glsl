// Hammersley's set: i/N, then the dimensions of Halton's sequence. [Hammersley 60]
#include "samplers/radical_inverse.glsl"

// floor(2^32 a / b), a < b <= 2^31, bit by bit.
uint fixedPointRatio(uint a, uint b) {
    uint ratio = 0u;
    for (uint k = 0u; k < 32u; ++k) {
        a <<= 1u;
        uint bit = a >= b ? 1u : 0u;
        a -= bit * b;
        ratio = (ratio << 1u) | bit;
    }
    return ratio;
}

uint hammersleyBits(SampleId id, uint dim) {
    if (dim != 0u) return haltonDimension(id, dim - 1u);
    uint bits = fixedPointRatio(id.index % id.spp, id.spp), key = samplerKey(id.pixel, kNone, id.seed, 0u).x;
    if (kScramble == kScrambleOwen) return owenScramble(bits, key);
    return kScramble == kScrambleDigit ? bits ^ key : bits;
}
