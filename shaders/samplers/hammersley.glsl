// Hammersley's set: i/N, then the dimensions of Halton's sequence. [Hammersley 60]
#include "samplers/radical_inverse.glsl"

// floor(2^32 a / b), a < b <= 2^31, by the upper words of a times 1/b: floor((2^64 - 1) / b) = 2^32 high + low falls
// short by less than 1/a, so the quotient by one at most. Where b is a constant all but the last lines fold.
uint fixedPointRatio(uint a, uint b) {
    uint high = 0xffffffffu / b, rest = 0xffffffffu % b, low = 0u;
    for (uint k = 0u; k < 32u; ++k) {  // (2^32 rest + 2^32 - 1) / b, bit by bit
        rest = 2u * rest + 1u;
        uint bit = rest >= b ? 1u : 0u;
        rest -= bit * b;
        low = (low << 1u) | bit;
    }
    uint ratio = a * high + multiplyHigh(a, low);
    return ratio + (0u - ratio * b >= b ? 1u : 0u);  // 2^32 a - ratio b, of which 32 bits suffice
}

uint hammersleyFirst(SampleId id) {
    uint bits = fixedPointRatio(id.index % id.spp, id.spp), key = samplerKey(id.pixel, kNone, id.seed, 0u).x;
    if (kScramble == kScrambleOwen) return owenScramble(bits, key);
    return kScramble == kScrambleDigit ? bits ^ key : bits;
}

uvec2 hammersleyPair(SampleId id, uint pair) {
    uvec2 halton = haltonDimensions(id, uvec2(max(2u * pair, 1u) - 1u, 2u * pair));
    return uvec2(pair == 0u ? hammersleyFirst(id) : halton.x, halton.y);
}
