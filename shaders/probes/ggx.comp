#version 460
// In: wo, alpha; wm, cosI; u. Out: D, G1(wo), G2, reflection pdf; a sampled visible normal.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 3u, kOutputWords = 2u;
#include "probes/probe.glsl"
#include "math/trigonometry.glsl"
#include "microfacet/ggx.glsl"

void main() {
    if (isIdle()) return;
    vec4 wo = inputFloat(0u), wm = inputFloat(1u);
    float alpha = wo.w;
    putFloat(0u, vec4(ggxD(alpha, wm.xyz), ggxG1(alpha, wo.z), ggxG2(alpha, wo.z, wm.w),
                      ggxReflectionPdf(alpha, wo.z, wm.xyz)));
    putFloat(1u, vec4(ggxSampleVisibleNormal(vec2(alpha), wo.xyz, inputFloat(2u).xy), 0.0));
}
