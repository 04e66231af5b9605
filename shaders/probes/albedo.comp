#version 460
// In: w, table; alphas, c, 1 where rows are azimuths; u. Out: the table at w, and its mean; a direction of the lobe of
// interreflection, its pdf; the walk's row as a conductor's cosines, escapes; its place, and as a dielectric's row.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 3u, kOutputWords = 5u;
#include "probes/scene_probe.glsl"
#include "math/exponential.glsl"
#include "microfacet/albedo.glsl"

void main() {
    if (isIdle()) return;
    vec4 w = inputFloat(0u), more = inputFloat(1u);
    uint table = floatBitsToUint(w.w);
    AlbedoRoughness roughness = AlbedoRoughness(more.xy, floatBitsToUint(more.w) != 0u);
    putFloat(0u, vec4(albedoLookup(table, roughness, w.xyz), 0.0));
    putFloat(1u, vec4(albedoMean(table, roughness), 0.0));
    vec3 wi = sampleInterreflection(more.z, inputFloat(2u).xy);
    putFloat(2u, vec4(wi, interreflectionPdf(more.z, wi.z)));
    MetalWalk metal = metalWalk(table, roughness);
    GlassWalk glass = glassWalk(table, roughness);
    putFloat(3u, vec4(metal.cosines, metal.escapes));
    putFloat(4u, vec4(metal.place, glass.share, glass.slope, glass.place));
}
