// Radical inverses in prime bases, scrambled or not.
// Table: a word a base b: {b | digits K << 11 | upper half of M << 16, floor((2^32 - 1) / b), lower half of M, first of the
// Faure permutation}; b^K is the first power of b of 24 bits or more, M = ceil(2^64 / b^K). Then Faure's permutations,
// 16 bits an element.
#ifndef VKPT_SAMPLERS_RADICAL_INVERSE
#define VKPT_SAMPLERS_RADICAL_INVERSE
#include "samplers/bits.glsl"

uint faureDigit(uint first, uint digit) {
    uint element = first + digit;
    return (sceneWord(scene.samplerTable + (element >> 3u))[(element >> 1u) & 3u] >> ((element & 1u) * 16u)) & 0xffffu;
}

// The next digit of an index, the lowest first; `key` changes from digit to digit.
uint scrambledDigit(uint digit, Divisor base, uint faureFirst, inout uint key) {
    if (kScramble == kScrambleFaure) return faureDigit(faureFirst, digit);
    if (kScramble == kScrambleNone) return digit;
    uint node = mixBits(key);
    key = kScramble == kScrambleOwen ? node ^ digit : node;
    uint factor = 1u + (((node * 0x9e3779b9u) >> 16u) * (base.d - 1u) >> 16u);
    return divide(factor * digit + multiplyHigh(node, base.d), base).y;
}

// Bases from 17 on have 6 digits at most, and those are all that bounces draw while their dimensions do not repeat;
// base 2 has 24. A loop of known length may unroll.
const uint kDigitsAtOnce = 6u;
const uint kMostDigits = kFirstDimension >= kDimBounce && kManyDimensions == 0u ? kDigitsAtOnce : 24u;

// Inverse of `index` in prime number `d`, 32-bit fixed point; digits beyond 24 bits do not count.
// none; faure: one permutation a base [Faure 92]; digit: a random one a place; owen: a random one a node of the digit
// tree. Random ones are affine maps modulo b: any two digits go to any two others alike, which is all that the variance
// of nested uniform scrambling rests on. [Owen 03]
uint radicalInverse(uint index, uint d, uint key) {
    uvec4 entry = sceneWord(scene.samplerTable + d);
    Divisor base = Divisor(entry.x & 0x7ffu, entry.y);
    uint digits = (entry.x >> 11u) & 31u, rest = index, value = 0u;
    for (uint k = 0u; k < kMostDigits; k += kDigitsAtOnce) {
        for (uint j = 0u; j < kDigitsAtOnce; ++j) {
            uvec2 split = divide(rest, base);
            rest = split.x;
            uint digit = scrambledDigit(split.y, base, entry.w, key);
            value = k + j < digits ? value * base.d + digit : value;
        }
    }
    return value * (entry.x >> 16u) + multiplyHigh(value, entry.z);
}

// Dimension `dim`, its bases repeating. What is not scrambled is at least rotated where it repeats.
uint haltonDimension(SampleId id, uint dim) {
    uint bits = radicalInverse(id.index, dim % kHaltonDimensions, samplerKey(id.pixel, dim, id.seed, 0u).x);
    if ((kScramble == kScrambleNone || kScramble == kScrambleFaure) && dim >= kHaltonDimensions)
        bits += samplerKey(0u, dim, 0u, 0u).x;
    return bits;
}
#endif
