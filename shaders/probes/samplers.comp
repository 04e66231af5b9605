#version 460
// In: pixel, index, spp, seed; dimension. Out: samplerBits of sampler kSampler; their toUnit (bits).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
const uint kInputWords = 2u, kOutputWords = 1u;
#include "probes/scene_probe.glsl"
#include "samplers.glsl"

void main() {
    if (isIdle()) return;
    uvec4 id = inputWord(0u);
    uint bits = samplerBits(SampleId(id.x, id.y, id.z, id.w), inputWord(1u).x);
    putWord(0u, uvec4(bits, floatBitsToUint(toUnit(bits)), 0u, 0u));
}
