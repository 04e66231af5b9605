#version 460
// In: wo, alphaX; wm, alphaY; wi, BsdfRecord.flags; u, uChoice. Out: D, G1(wo), G2, pdf of wm; a sampled wm, what is left
// of uChoice; a wm of density D cos.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 4u, kOutputWords = 3u;
#include "probes/probe.glsl"
#include "math/trigonometry.glsl"
#include "math/exponential.glsl"
#include "math/erf.glsl"
#include "microfacet/ggx.glsl"
#include "microfacet/facets.glsl"

void main() {
    if (isIdle()) return;
    vec4 wo = inputFloat(0u), wm = inputFloat(1u), wi = inputFloat(2u), u = inputFloat(3u);
    BsdfRecord r;
    r.alphaX = wo.w;
    r.alphaY = wm.w;
    r.flags = floatBitsToUint(wi.w);
    Facets f = makeFacets(r);
    putFloat(0u, vec4(facetsD(f, wm.xyz), facetsG1(f, wo.xyz, wm.xyz), facetsG2(f, wo.xyz, wi.xyz, wm.xyz),
                      facetsPdf(f, wo.xyz, wm.xyz)));
    float choice = u.z;
    vec3 sampled = facetsSample(f, wo.xyz, u.xy, choice);
    putFloat(1u, vec4(sampled, choice));
    putFloat(2u, vec4(facetsSampleD(f, u.xy), 0.0));
}
