// Radical inverses in prime bases, scrambled or not.
// Table: a word a base b: {b | D << 11 | upper half of M << 16, floor((2^32 - 1) / b), lower half of M, b^(K - D)}; b^K is
// the first power of b of 24 bits or more, M = ceil(2^64 / b^K), D digits of the K hold every sample index. Under faure,
// where the permutation of each base begins, then the permutations, 16 bits an element.
#ifndef VKPT_SAMPLERS_RADICAL_INVERSE
#define VKPT_SAMPLERS_RADICAL_INVERSE
#include "samplers/bits.glsl"

// Faure's permutation of the d-th prime. [Faure 92]
uint faureDigit(uint d, uint digit) {
    uint first = sceneWord(scene.samplerTable + kHaltonDimensions + (d >> 2u))[d & 3u], element = first + digit;
    return (sceneWord(scene.samplerTable + (element >> 3u))[(element >> 1u) & 3u] >> ((element & 1u) * 16u)) & 0xffffu;
}

// An index on its way to its inverse, digit by digit from the lowest.
struct DigitWalk {
    uvec4 entry;  // of the table
    Divisor base;
    uint d, digits, rest, value, key;
};

// `d`: number of a prime. `key` names the scramble; unscrambled digits end in zeros.
DigitWalk beginWalk(uint index, uint d, uint key) {
    uvec4 entry = sceneWord(scene.samplerTable + d);
    bool random = kScramble == kScrambleOwen || kScramble == kScrambleDigit;
    return DigitWalk(entry, Divisor(entry.x & 0x7ffu, entry.y), d, (entry.x >> 11u) & 31u, index, 0u, random ? key : 0u);
}

// Random permutations are affine maps modulo b: any two digits go to any two others alike, which is all that the
// variance of nested uniform scrambling rests on. [Owen 03]
uint permuteDigit(DigitWalk w, uint digit) {
    if (kScramble == kScrambleFaure) return faureDigit(w.d, digit);
    if (kScramble == kScrambleNone) return digit;
    uint factor = 1u + ((w.key & 0xffffu) * (w.base.d - 1u) >> 16u);
    uint n = factor * digit + multiplyHigh(w.key, w.base.d);
    uint remainder = n - multiplyHigh(n, w.base.reciprocal) * w.base.d;  // or b more
    return min(remainder, remainder - w.base.d);
}

// Digit number k, as long as there are any but zeros. digit: a permutation a place; owen: a permutation a node of the
// tree of digits, where below a zero lies what below it lay in the fraction key / 2^32.
void takeDigit(inout DigitWalk w, uint k) {
    uvec2 split = divide(w.rest, w.base);
    uint value = w.value * w.base.d + permuteDigit(w, split.y), key = w.key * w.base.d;
    if (kScramble == kScrambleOwen && split.y != 0u) key = mixBits(w.key ^ split.y);
    bool counts = k < w.digits;
    w.rest = split.x;
    w.value = counts ? value : w.value;
    w.key = counts ? key : w.key;
}

// All zeros that follow become the first digits of key / 2^32.
uint inverseOf(DigitWalk w) {
    uint value = w.value * w.entry.w + multiplyHigh(w.key, w.entry.w);
    return value * (w.entry.x >> 16u) + multiplyHigh(value, w.entry.z);
}

// Inverses of `index` in prime numbers d.x and d.y, 32-bit fixed point. Two at a time, since a loop saves and loads all
// that is live at each round.
uvec2 radicalInverses(uint index, uvec2 d, uvec2 keys) {
    DigitWalk a = beginWalk(index, d.x, keys.x), b = beginWalk(index, d.y, keys.y);
    uint digits = max(a.digits, b.digits);
    for (uint k = 0u; k < digits; ++k) {
        takeDigit(a, k);
        takeDigit(b, k);
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
