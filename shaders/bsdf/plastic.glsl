// A smooth or rough dielectric coat over a diffuse base; light that the base sends back may be reflected inside, again
// and again. [Kulla 17]
float plasticPassed(SurfaceBsdf b, vec3 w) {
    if (b.facets.delta) return 1.0 - fresnelDielectricExact(abs(w.z), b.r.eta.x);
    vec3 albedo = albedoLookup(b.table, b.roughness, w);
    return albedo.y + albedo.z;
}
float plasticPassedO(SurfaceBsdf b, vec3 wo) {
    return b.facets.delta ? 1.0 - fresnelDielectricExact(wo.z, b.r.eta.x) : b.albedoO.y + b.albedoO.z;
}

float plasticShare(SurfaceBsdf b, vec3 wo) {
    float passed = plasticPassedO(b, wo);
    return specularShare(1.0 - passed, passed * luminance(b.r.diffuse));
}

BsdfValue plasticEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    float eta2 = b.r.eta.x * b.r.eta.x, mean = b.facets.delta ? 1.0 - b.r.average.x : b.mean.y + b.mean.z;
    float passed = plasticPassedO(b, wo) * plasticPassed(b, wi) / eta2;
    BsdfValue base = diffuseValue(passed * b.r.diffuse / (1.0 - b.r.diffuse * (1.0 - mean / eta2)), wi);
    if (b.facets.delta) return mixValues(kNoValue, base, plasticShare(b, wo));
    vec3 wm = normalize(wo + wi);
    return mixValues(facetReflection(b, wo, wi, fresnelOf(b.r, abs(dot(wo, wm))), wm), base, plasticShare(b, wo));
}

LobeSample plasticSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    float share = plasticShare(b, wo);
    bool coat = chooseFirst(uLobe, share);
    if (coat && b.facets.delta) return sampleDelta(vec3(-wo.xy, wo.z), fresnelOf(b.r, wo.z) / share);
    vec3 wm = facetsSample(b.facets, wo, u, uLobe);
    return sampleLobe(coat ? reflectAbout(wo, wm) : squareToCosineHemisphere(u));
}
