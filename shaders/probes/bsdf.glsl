// A BSDF of the group whose file is included before. In: wo, material; wi, model; uLobe, u, front; colour and roughness
// of its maps. Out: f(wo, wi), pdf; sampled wi, pdf; its weight.
void main() {
    if (isIdle()) return;
    vec4 wo = inputFloat(0u), wi = inputFloat(1u), u = inputFloat(2u), map = inputFloat(3u);
    SurfaceBsdf b = makeSurfaceBsdf(loadBsdf(floatBitsToUint(wo.w)), floatBitsToUint(wi.w), map.rgb, map.a,
                                    floatBitsToUint(u.w) != 0u, wo.xyz);
    vec3 f;
    float pdf;
    evaluateBsdf(b, wo.xyz, wi.xyz, f, pdf);
    BsdfSample s = sampleBsdf(b, wo.xyz, u.x, u.yz);
    putFloat(0u, vec4(f, pdf));
    putFloat(1u, vec4(s.wi, s.pdf));
    putFloat(2u, vec4(s.weight, 0.0));
}
