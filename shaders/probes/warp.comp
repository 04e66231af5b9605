#version 460
// In: a point of the unit square. Out: its image on the disk; on the hemisphere, by cosine and uniformly.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 3u;
#include "probes/probe.glsl"
#include "math/trigonometry.glsl"
#include "math/warp.glsl"

void main() {
    if (isIdle()) return;
    vec2 u = inputFloat(0u).xy;
    putFloat(0u, vec4(squareToDisk(u), 0.0, 0.0));
    putFloat(1u, vec4(squareToCosineHemisphere(u), 0.0));
    putFloat(2u, vec4(squareToUniformHemisphere(u), 0.0));
}
