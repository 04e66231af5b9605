// Progressive multi-jittered (0,2) sequences [Christensen 18]: tables, of which a pixel's dimension pairs take one
// after the other, Owen-scrambled; samples beyond a table begin a freshly scrambled one.
// Table: kPmj02Tables times kPmj02Points points, x | y << 16, four a word.
#include "samplers/bits.glsl"

uvec2 pmj02Pair(SampleId id, uint pair) {
    uint copy = id.index / kPmj02Points;
    // A bounce uses the first four of its eight pairs: those of the camera and seven bounces get tables of their own.
    uint order = (pair & 3u) + 4u * ((pair + 4u) >> 3u);
    uint table = (samplerKey(id.pixel, kNone, id.seed, copy).x + order) % kPmj02Tables;
    uint point = table * kPmj02Points + id.index % kPmj02Points;
    uint packed = sceneWord(scene.samplerTable + (point >> 2u))[point & 3u];
    uvec4 key = samplerKey(id.pixel, pair, id.seed, copy);
    return uvec2(owenScramble(packed << 16u, key.x), owenScramble(packed & 0xffff0000u, key.y));
}
