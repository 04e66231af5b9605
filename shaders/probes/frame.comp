#version 460
// In: a unit normal; a vector. Out: tangent, bitangent and normal of its frame; the vector in the frame, and back.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 5u;
#include "probes/probe.glsl"
#include "math/frame.glsl"

void main() {
    if (isIdle()) return;
    ShadingFrame f = makeFrame(inputFloat(0u).xyz);
    vec3 local = toLocal(f, inputFloat(1u).xyz);
    putFloat(0u, vec4(f.t, 0.0));
    putFloat(1u, vec4(f.b, 0.0));
    putFloat(2u, vec4(f.n, 0.0));
    putFloat(3u, vec4(local, 0.0));
    putFloat(4u, vec4(toWorld(f, local), 0.0));
}
