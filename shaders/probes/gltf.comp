#version 460
// In: base colour, metallic; wo, alpha; wi; uLobe, u. Out: f(wo, wi), pdf; sampled wi, pdf; its weight, the probability of the specular lobe;
// that of interreflection.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 4u, kOutputWords = 4u;
#include "probes/scene_probe.glsl"
#include "bsdf/bsdf.glsl"
#include "microfacet/ggx.glsl"
#include "math/exponential.glsl"
#include "microfacet/albedo.glsl"
#include "bsdf/gltf.glsl"

void main() {
    if (isIdle()) return;
    vec4 base = inputFloat(0u), wo = inputFloat(1u), u = inputFloat(3u);
    GltfBsdf b = makeGltfBsdf(base.rgb, base.a, wo.w, wo.xyz);
    vec3 f;
    float pdf;
    gltfEvaluate(b, wo.xyz, inputFloat(2u).xyz, f, pdf);
    BsdfSample s = gltfSample(b, wo.xyz, u.x, u.yz);
    putFloat(0u, vec4(f, pdf));
    putFloat(1u, vec4(s.wi, s.pdf));
    GltfChoices choices = gltfChoices(b, wo.z);
    putFloat(2u, vec4(s.weight, choices.specular));
    putFloat(3u, vec4(choices.interreflection));
}
