#version 460
// In: a colour; two densities and the heuristic's exponent. Out: its linear form and luminance; largest component, MIS
// weight of the densities.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 2u;
#include "probes/probe.glsl"
#include "math/color.glsl"
#include "math/mis.glsl"

void main() {
    if (isIdle()) return;
    vec3 c = inputFloat(0u).rgb;
    vec4 pdfs = inputFloat(1u);
    putFloat(0u, vec4(srgbToLinear(c), luminance(c)));
    putFloat(1u, vec4(maxComponent(c), misWeight(pdfs.x, pdfs.y, pdfs.z), 0.0, 0.0));
}
