#version 460
// In: eta, cosine; k. Out: reflectance of dielectrics of ior eta.x and 1 / eta.x; of a conductor; Schlick's of F0 = eta.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 3u;
#include "probes/probe.glsl"
#include "microfacet/fresnel.glsl"

void main() {
    if (isIdle()) return;
    vec4 eta = inputFloat(0u);
    putFloat(0u, vec4(fresnelDielectricExact(eta.w, eta.x), fresnelDielectricExact(eta.w, 1.0 / eta.x), 0.0, 0.0));
    putFloat(1u, vec4(fresnelConductor(eta.w, eta.xyz, inputFloat(1u).xyz), 0.0));
    putFloat(2u, vec4(fresnelSchlick(eta.w, eta.xyz), 0.0));
}
