// Dithered sampling [Georgiev 16]: one padded (0,2)-sequence for all pixels, shifted in each by a blue-noise mask. Every
// dimension moves the mask elsewhere; a hash fills the bits below the mask's.
// Table: kMaskSide^2 ranks of 14 bits, row by row, 16 bits each.
#include "samplers/net02.glsl"

uint maskShift(SampleId id, uint dim) {
    uint offset = samplerKey(kNone, dim, id.seed, 1u).x;
    uint column = (id.pixel + (offset & 0xffffu)) % kMaskSide, row = ((id.pixel >> 16u) + (offset >> 16u)) % kMaskSide;
    uint cell = row * kMaskSide + column;
    uint rank = (sceneWord(scene.samplerTable + (cell >> 3u))[(cell >> 1u) & 3u] >> ((cell & 1u) * 16u)) & 0xffffu;
    return (rank << 18u) | (samplerKey(id.pixel, dim, id.seed, 0u).x >> 14u);
}

uvec2 bluenoisePair(SampleId id, uint pair) {
    return scrambledNet02(id.index, samplerKey(kNone, pair, id.seed, 0u)) +
           uvec2(maskShift(id, 2u * pair), maskShift(id, 2u * pair + 1u));
}
