#version 460
// In: direction; u. Out: radiance and pdf of the direction; a sampled direction and its pdf.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 2u;
#include "probes/scene_probe.glsl"
#include "lights/environment.glsl"

void main() {
    if (isIdle()) return;
    float pdf;
    vec3 sampled = sampleEnvironmentDirection(inputFloat(1u).xy, pdf);
    putFloat(0u, environmentLookup(inputFloat(0u).xyz));
    putFloat(1u, vec4(sampled, pdf));
}
