#version 460
// In: packed normal, packed tangent. Out: both unpacked.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 2u;
#include "probes/probe.glsl"
#include "geometry/octahedral.glsl"

void main() {
    if (isIdle()) return;
    uvec4 packed = inputWord(0u);
    putFloat(0u, vec4(unpackNormal(packed.x), 0.0));
    putFloat(1u, unpackTangent(packed.y));
}
