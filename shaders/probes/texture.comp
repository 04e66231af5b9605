#version 460
// In: uv, texture index. Out: sampleTexture.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 1u;
#include "probes/scene_probe.glsl"
#include "material/texture.glsl"

void main() {
    if (isIdle()) return;
    uvec4 in0 = inputWord(0u);
    putFloat(0u, sampleTexture(loadTexture(in0.z), uintBitsToFloat(in0.xy)));
}
