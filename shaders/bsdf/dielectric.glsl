// Glass: facets that reflect and refract [Walter 07], and what they pass on among each other [Kulla 17]. f is of
// radiance: what enters a denser medium is compressed by eta^2.

// Probabilities of the interreflected light, and within it of transmission.
struct DielectricLosses {
    float lost;          // 1 - E of the side of wo, at wo
    float transmitted;   // rho of estimator.md
    float meanX, meanY;  // 1 - mean E of the side of wo and of the other
};

uint dielectricOtherTable(SurfaceBsdf b) { return b.front ? b.r.table + kAlbedoTableWords : b.r.table; }

DielectricLosses dielectricLosses(SurfaceBsdf b) {
    DielectricLosses l = DielectricLosses(0.0, 0.0, 0.0, 0.0);
    if (!b.compensated) return l;
    l.meanX = b.mean.z;
    l.meanY = albedoMean(dielectricOtherTable(b), b.roughness).z;
    l.lost = b.albedoO.z;
    float both = l.meanX + l.meanY;
    l.transmitted = both > 0.0 ? (1.0 - (b.front ? b.r.average.x : b.r.average.y)) * l.meanY / both : 0.0;
    return l;
}

BsdfValue dielectricReflection(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 wm = normalize(wo + wi);
    float fresnel = fresnelDielectricExact(abs(dot(wo, wm)), b.eta);
    BsdfValue v = facetReflection(b, wo, wi, vec3(fresnel), wm);
    v.pdf *= fresnel;
    return v;
}

// [Walter 07, eq. 21]
BsdfValue dielectricTransmission(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 wm = wo + b.eta * wi;
    float length2 = dot(wm, wm);
    if (length2 <= 0.0) return kNoValue;
    wm *= (wm.z < 0.0 ? -1.0 : 1.0) * inversesqrt(length2);
    float cosO = dot(wo, wm), cosI = dot(wi, wm);
    if (cosO <= 0.0 || cosI >= 0.0) return kNoValue;
    float passed = 1.0 - fresnelDielectricExact(cosO, b.eta), way = cosI + cosO / b.eta;
    float jacobian = -cosI / (way * way);
    float d = facetsD(b.facets, wm) * facetsG2(b.facets, wo, wi, wm) * cosO * jacobian / (b.eta * b.eta);
    return BsdfValue(b.r.color * (passed * d / (wo.z * -wi.z)), passed * facetsPdf(b.facets, wo, wm) * jacobian);
}

BsdfValue dielectricEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    if (b.facets.delta) return kNoValue;
    bool through = wi.z < 0.0;
    BsdfValue v = through ? dielectricTransmission(b, wo, wi) : dielectricReflection(b, wo, wi);
    if (!b.compensated) return v;
    DielectricLosses l = dielectricLosses(b);
    float lostI = albedoLookup(through ? dielectricOtherTable(b) : b.table, b.roughness, wi).z;
    float shape = interreflection(l.lost, lostI, through ? l.meanY : l.meanX);
    float share = through ? l.transmitted : 1.0 - l.transmitted;
    vec3 tint = through ? b.r.color / (b.eta * b.eta) : vec3(1.0);
    return mixValues(v, BsdfValue(tint * (share * shape), share * interreflectionPdf(lostSpread(b), wi.z)), 1.0 - l.lost);
}

// The direction beyond the facet; not to be asked for at total internal reflection.
vec3 refractThrough(vec3 wo, vec3 wm, float eta) {
    float cosO = dot(wo, wm), cosT = sqrt(max(1.0 - (1.0 - cosO) * (1.0 + cosO) / (eta * eta), 0.0));
    return (cosO / eta - cosT) * wm - wo / eta;
}

LobeSample dielectricSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    DielectricLosses l = dielectricLosses(b);
    bool delta = b.facets.delta, multiple = chooseFirst(uLobe, l.lost);
    float uFacet = uLobe;
    vec3 wm = delta ? vec3(0.0, 0.0, 1.0) : facetsSample(b.facets, wo, u, uFacet);
    float cosO = dot(wo, wm);
    bool reflected = chooseFirst(uFacet, fresnelDielectricExact(max(cosO, 0.0), b.eta));
    vec3 wi = reflected ? reflectAbout(wo, wm) : refractThrough(wo, wm, b.eta);
    bool valid = cosO > 0.0 && (wi.z > 0.0) == reflected;
    if (delta) return sampleDelta(wi, reflected ? vec3(1.0) : b.r.color / (b.eta * b.eta));
    if (multiple) {
        wi = sampleInterreflection(lostSpread(b), u);
        wi.z = chooseFirst(uLobe, l.transmitted) ? -wi.z : wi.z;
        valid = true;
    }
    return sampleLobe(valid ? wi : vec3(0.0));
}
