// Metal: mirror facets [Walter 07], and what they pass on among each other [Kulla 17].

// Shares of that light that are given back: along the normal and where grazing; and its mean albedo.
struct ConductorReturns {
    vec3 along, grazing, mean;
};

ConductorReturns conductorReturns(SurfaceBsdf b) {
    MetalWalk walk = metalWalk(b.table, b.roughness);
    vec3 along = interreflectedShare(b.r.color * fresnelOf(b.r, walk.cosines.x), 1.0 - walk.escapes.x);
    vec3 grazing = interreflectedShare(b.r.color * fresnelOf(b.r, walk.cosines.y), 1.0 - walk.escapes.y);
    return ConductorReturns(along, grazing, b.mean.z * mix(along, grazing, walk.place));
}

// M of estimator.md.
vec3 conductorReturned(ConductorReturns r, float lost, float cosW) {
    float steep = 1.0 - cosW;
    return lost * mix(r.along, r.grazing, steep * steep);
}

// Probability of the facets' own lobe.
float conductorFacetShare(SurfaceBsdf b, vec3 wo) {
    if (!b.compensated) return 1.0;
    float lost = b.albedoO.z;
    vec3 returned = conductorReturned(conductorReturns(b), lost, wo.z);
    return specularShare(luminance(b.r.color * fresnelOf(b.r, wo.z)) * (1.0 - lost), luminance(returned));
}

BsdfValue conductorEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    if (b.facets.delta) return kNoValue;
    vec3 wm = normalize(wo + wi);
    BsdfValue single = facetReflection(b, wo, wi, b.r.color * fresnelOf(b.r, abs(dot(wo, wm))), wm);
    if (!b.compensated) return single;
    ConductorReturns r = conductorReturns(b);
    vec3 o = conductorReturned(r, b.albedoO.z, wo.z);
    vec3 i = conductorReturned(r, albedoLookup(b.table, b.roughness, wi).z, wi.z);
    vec3 f = o * i * kInvPi / max(r.mean, vec3(1e-30));   // 0 where nothing is given back
    BsdfValue multiple = BsdfValue(f, interreflectionPdf(lostSpread(b), wi.z));
    return mixValues(single, multiple, conductorFacetShare(b, wo));
}

LobeSample conductorSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    if (b.facets.delta) return sampleDelta(vec3(-wo.xy, wo.z), b.r.color * fresnelOf(b.r, wo.z));
    bool single = chooseFirst(uLobe, conductorFacetShare(b, wo));
    vec3 wm = facetsSample(b.facets, wo, u, uLobe);
    return sampleLobe(single ? reflectAbout(wo, wm) : sampleInterreflection(lostSpread(b), u));
}
