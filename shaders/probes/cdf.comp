#version 460
// In: first word of the table, its length, u, steps. Out: searchCdf.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 1u;
#include "probes/scene_probe.glsl"

void main() {
    if (isIdle()) return;
    uvec4 in0 = inputWord(0u);
    putWord(0u, uvec4(searchCdf(in0.x, in0.y, uintBitsToFloat(in0.z), in0.w), 0u));
}
