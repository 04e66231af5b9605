// Progressive multi-jittered (0,2) sequences [Christensen 18]: tables, of which a pixel's dimension pairs take one
// after the other, shuffled and Owen-scrambled; samples beyond a table begin a freshly scrambled one.
// Table: kPmj02Tables times kPmj02Points points, x | y << 16, four a word.
#include "samplers/bits.glsl"

// Another order of a table that keeps every first 2^k points together: below the index's highest bit, a nested shuffle.
// Unshuffled, all tables turn to opposite quadrants at the same samples, which ties the pairs of a path together.
uint shuffleProgressively(uint index, uint key) {
    uint highest = uint(findMSB(max(index, 1u))), shift = 32u - highest;
    return index < 2u ? index : (1u << highest) | (owenScramble(index << shift, key) >> shift);
}

uvec2 pmj02Pair(SampleId id, uint pair) {
    uint copy = id.index / kPmj02Points;
    uint table = (samplerKey(id.pixel, kNone, id.seed, copy).x + pair) % kPmj02Tables;
    uvec4 key = samplerKey(id.pixel, pair, id.seed, copy);
    uint point = table * kPmj02Points + shuffleProgressively(id.index % kPmj02Points, key.z);
    uint packed = sceneWord(scene.samplerTable + (point >> 2u))[point & 3u];
    return uvec2(owenScramble(packed << 16u, key.x), owenScramble(packed & 0xffff0000u, key.y));
}
