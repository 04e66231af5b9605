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

// An index on its way to its inverse, digit by digit from the lowest.
struct DigitWalk {
    uvec4 entry;  // of the table
    Divisor base;
    uint rest, value, key;
};

// `d`: number of a prime. `key` names the scramble.
DigitWalk beginWalk(uint index, uint d, uint key) {
    uvec4 entry = sceneWord(scene.samplerTable + d);
    return DigitWalk(entry, Divisor(entry.x & 0x7ffu, entry.y), index, 0u, key);
}

uint digitsOf(DigitWalk w) { return (w.entry.x >> 11u) & 31u; }

// none; faure: one permutation a base [Faure 92]; digit: a random one a place; owen: a random one a node of the digit
// tree. Random ones are affine maps modulo b: any two digits go to any two others alike, which is all that the variance
// of nested uniform scrambling rests on. [Owen 03]
uint scrambleDigit(inout DigitWalk w, uint digit) {
    if (kScramble == kScrambleFaure) return faureDigit(w.entry.w, digit);
    if (kScramble == kScrambleNone) return digit;
    uint node = mixBits(w.key);
    w.key = kScramble == kScrambleOwen ? node ^ digit : node;
    uint factor = 1u + (((node * 0x9e3779b9u) >> 16u) * (w.base.d - 1u) >> 16u);
    return divide(factor * digit + multiplyHigh(node, w.base.d), w.base).y;
}

// Digit number k; those beyond 24 bits do not count.
void takeDigit(inout DigitWalk w, uint k) {
    uvec2 split = divide(w.rest, w.base);
    w.rest = split.x;
    uint digit = scrambleDigit(w, split.y);
    w.value = k < digitsOf(w) ? w.value * w.base.d + digit : w.value;
}

uint inverseOf(DigitWalk w) { return w.value * (w.entry.x >> 16u) + multiplyHigh(w.value, w.entry.z); }

// Inverses of `index` in prime numbers d.x and d.y, 32-bit fixed point. Two at a time, and eight digits at a time, which
// is all that bases from 11 on have: a loop saves and loads all that is live at each round.
const uint kDigitsAtOnce = 8u;

uvec2 radicalInverses(uint index, uvec2 d, uvec2 keys) {
    DigitWalk a = beginWalk(index, d.x, keys.x), b = beginWalk(index, d.y, keys.y);
    uint digits = max(digitsOf(a), digitsOf(b));
    for (uint begin = 0u; begin < digits; begin += kDigitsAtOnce) {
        for (uint k = 0u; k < kDigitsAtOnce; ++k) {
            takeDigit(a, begin + k);
            takeDigit(b, begin + k);
        }
    }
    return uvec2(inverseOf(a), inverseOf(b));
}

// What is not scrambled is at least rotated where bases repeat.
uint rotationOf(uint dim) {
    bool plain = kScramble == kScrambleNone || kScramble == kScrambleFaure;
    return plain && dim >= kHaltonDimensions ? samplerKey(0u, dim, 0u, 0u).x : 0u;
}

// Two dimensions of Halton's sequence.
uvec2 haltonDimensions(SampleId id, uvec2 dims) {
    uvec2 keys = uvec2(samplerKey(id.pixel, dims.x, id.seed, 0u).x, samplerKey(id.pixel, dims.y, id.seed, 0u).x);
    return radicalInverses(id.index, dims % kHaltonDimensions, keys) + uvec2(rotationOf(dims.x), rotationOf(dims.y));
}
#endif
