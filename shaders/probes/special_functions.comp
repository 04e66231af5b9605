#version 460
// In: x; q; t; y; tan^2, e; u, n. Out: erf(x), erf^-1(2q - 1), ln(1 + t), 1 - exp(y); cosine power, (cos, sin) of the
// angle whose cos^n is 1 - u.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 2u;
#include "probes/probe.glsl"
#include "math/exponential.glsl"
#include "math/erf.glsl"

void main() {
    if (isIdle()) return;
    vec4 a = inputFloat(0u), b = inputFloat(1u);
    putFloat(0u, vec4(erfAccurate(a.x), erfInverse(a.y), logOnePlus(a.z), oneMinusExp(a.w)));
    putFloat(1u, vec4(cosinePower(b.x, b.y), cosSinOfPower(b.z, b.w), 0.0));
}
