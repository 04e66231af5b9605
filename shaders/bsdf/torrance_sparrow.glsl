// Mirror facets in V-grooves. [Torrance 67]
BsdfValue torranceSparrowEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    if (b.facets.delta) return kNoValue;
    vec3 wm = normalize(wo + wi);
    return facetReflection(b, wo, wi, b.r.color * fresnelOf(b.r, abs(dot(wo, wm))), wm);
}

LobeSample torranceSparrowSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    if (b.facets.delta) return sampleDelta(vec3(-wo.xy, wo.z), b.r.color * fresnelOf(b.r, wo.z));
    return sampleLobe(reflectAbout(wo, facetsSample(b.facets, wo, u, uLobe)));
}
