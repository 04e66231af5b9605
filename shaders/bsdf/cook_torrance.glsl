// A diffuse part, and mirror facets in V-grooves whose slopes have two isotropic distributions. [Cook 81]; the divisor
// of the specular part is 4, not pi.
Facets cookTorranceFacets(SurfaceBsdf b, float alpha) {
    Facets f = b.facets;
    f.alpha = vec2(alpha);
    return f;
}

float cookTorranceShare(SurfaceBsdf b, vec3 wo) {
    return specularShare(b.r.specular * luminance(b.r.color * fresnelOf(b.r, wo.z)),
                         (1.0 - b.r.specular) * luminance(b.r.diffuse));
}

BsdfValue cookTorranceEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 wm = normalize(wo + wi), fresnel = b.r.color * fresnelOf(b.r, abs(dot(wo, wm)));
    Facets first = cookTorranceFacets(b, b.facets.alpha.x), second = cookTorranceFacets(b, b.facets.alpha.y);
    float d = mix(facetsD(second, wm), facetsD(first, wm), b.r.weight);
    float shown = facetsG1(first, wo, wm) * max(dot(wo, wm), 0.0) / wo.z;
    BsdfValue specular = BsdfValue(b.r.specular * fresnel * (d * facetsG2(first, wo, wi, wm) / (4.0 * wo.z * wi.z)),
                                   d * shown / (4.0 * dot(wo, wm)));
    return mixValues(specular, diffuseValue((1.0 - b.r.specular) * b.r.diffuse, wi), cookTorranceShare(b, wo));
}

LobeSample cookTorranceSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    bool specular = chooseFirst(uLobe, cookTorranceShare(b, wo)), first = chooseFirst(uLobe, b.r.weight);
    Facets f = cookTorranceFacets(b, first ? b.facets.alpha.x : b.facets.alpha.y);
    vec3 wm = facetsSample(f, wo, u, uLobe);
    return sampleLobe(specular ? reflectAbout(wo, wm) : squareToCosineHemisphere(u));
}
