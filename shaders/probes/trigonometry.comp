#version 460
// In: turns, y, x, cosine. Out: cos and sin of turns, atan2(y, x), acos(cosine).
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 1u, kOutputWords = 1u;
#include "probes/probe.glsl"
#include "math/trigonometry.glsl"

void main() {
    if (isIdle()) return;
    vec4 v = inputFloat(0u);
    putFloat(0u, vec4(cosSinTurns(v.x), atan2Accurate(v.y, v.z), acosAccurate(v.w)));
}
