// Shade group of glTF's own material.
#include "bsdf/bsdf.glsl"
#include "microfacet/ggx.glsl"
#include "math/exponential.glsl"
#include "microfacet/albedo.glsl"
#include "bsdf/gltf.glsl"

#define VertexBsdf GltfBsdf
const uint kShadeQueue = kQueueHit;

GltfBsdf makeVertexBsdf(ShadingPoint p, vec3 wo) {
    MaterialRecord m = p.material;
    float roughness = m.roughness * p.maps.metallicRoughness.g;
    vec3 color = surfaceBaseColor(m, p.uv, p.maps.baseColor).rgb;
    return makeGltfBsdf(color, m.metallic * p.maps.metallicRoughness.b, roughness * roughness, wo);
}
ShadingFrame makeVertexFrame(ShadingPoint p) { return p.frame; }

void evaluateBsdf(GltfBsdf b, vec3 wo, vec3 wi, out vec3 f, out float pdf) { gltfEvaluate(b, wo, wi, f, pdf); }

// The first number of the direction chooses the lobe; what is left of it goes on. [estimator.md, step 6]
BsdfSample sampleBsdf(GltfBsdf b, vec3 wo, float uLobe, vec2 u) {
    GltfChoices choices = gltfChoices(b, wo.z);
    float rest = kMultiscatter != 0u ? restOfChoice(u.x, choices.interreflection) : u.x;
    if (u.x >= choices.interreflection) rest = restOfChoice(rest, choices.specular);
    return gltfSample(b, wo, u.x, vec2(rest, u.y));
}
