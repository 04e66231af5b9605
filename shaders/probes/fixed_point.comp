#version 460
// In: a contribution, what was met; a sum a channel; a second contribution. Out: addContributions' sums; of the first,
// toFixedPoint of its channels; addFixed of the red and green sums; whether the first is refused.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 5u, kOutputWords = 7u;
#include "probes/probe.glsl"
layout(std430, binding = 2) buffer Counters { uint counters[]; };
const uint kRefused = 0u, kStateRed = 0u, kStateGreen = 1u, kStateBlue = 2u;
uvec4 pathState[3];
uvec4 loadState(uint array, uint path) { return pathState[array]; }
void storeState(uint array, uint path, uvec4 value) { pathState[array] = value; }
#include "kernels/contribution.glsl"

void main() {
    if (isIdle()) return;
    vec4 c = inputFloat(0u);
    for (uint i = 0u; i < 3u; ++i) pathState[i] = inputWord(1u + i);
    putWord(6u, uvec4(addFixed(pathState[0].xyz, pathState[1].xyz), isRefused(c.rgb) ? 1u : 0u));
    addContributions(gl_GlobalInvocationID.x, c.rgb, inputFloat(4u).rgb, false, uint(c.a));
    for (uint i = 0u; i < 3u; ++i) {
        putWord(i, pathState[i]);
        putWord(3u + i, uvec4(toFixedPoint(c[i]), 0u));
    }
}
