// Metal: mirror facets [Walter 07], and what they pass on among each other [Kulla 17].

// Share of that light, and its albedo at wo.
vec3 conductorShare(SurfaceBsdf b) { return interreflectedShare(b.r.color * b.r.average, b.mean.z); }

// Probability of the facets' own lobe.
float conductorFacetShare(SurfaceBsdf b, vec3 wo) {
    if (!b.compensated) return 1.0;
    float lost = b.albedoO.z;
    return specularShare(luminance(b.r.color * fresnelOf(b.r, wo.z)) * (1.0 - lost), luminance(conductorShare(b)) * lost);
}

BsdfValue conductorEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    if (b.facets.delta) return kNoValue;
    vec3 wm = normalize(wo + wi);
    BsdfValue single = facetReflection(b, wo, wi, b.r.color * fresnelOf(b.r, abs(dot(wo, wm))), wm);
    if (!b.compensated) return single;
    float shape = interreflection(b.albedoO.z, albedoLookup(b.table, b.roughness, wi).z, b.mean.z);
    BsdfValue multiple = BsdfValue(conductorShare(b) * shape, interreflectionPdf(lostSpread(b), wi.z));
    return mixValues(single, multiple, conductorFacetShare(b, wo));
}

LobeSample conductorSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    if (b.facets.delta) return sampleDelta(vec3(-wo.xy, wo.z), b.r.color * fresnelOf(b.r, wo.z));
    bool single = chooseFirst(uLobe, conductorFacetShare(b, wo));
    vec3 wm = facetsSample(b.facets, wo, u, uLobe);
    return sampleLobe(single ? reflectAbout(wo, wm) : sampleInterreflection(lostSpread(b), u));
}
