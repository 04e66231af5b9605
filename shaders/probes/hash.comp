#version 460
// In: v. Out: hash(v); toUnit of its components.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 2u;
#include "probes/probe.glsl"
#include "math/hash.glsl"

void main() {
    if (isIdle()) return;
    uvec4 h = hash(inputWord(0u));
    putWord(0u, h);
    putFloat(1u, vec4(toUnit(h.x), toUnit(h.y), toUnit(h.z), toUnit(h.w)));
}
