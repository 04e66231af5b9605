// Glass: facets that reflect and refract [Walter 07], and what they pass on among each other [Kulla 17]. f is of
// radiance: what enters a denser medium is compressed by eta^2.

// One side of the light that more than one facet meets.
struct DielectricSide {
    float mean;          // 1 - mean E
    float share;         // of it that is transmitted, in the mean
    float slope, place;  // and how that changes with direction
};

struct DielectricLosses {
    float lost;          // 1 - E of the side of wo, at wo
    float probability;   // of their lobe
    float transmitted;   // its share
    DielectricSide x, y; // the side of wo and the other
};

uint dielectricOtherTable(SurfaceBsdf b) { return b.front ? b.r.table + kAlbedoTableWords : b.r.table; }

// The slope is held where shares stay within 0 and 1.
DielectricSide dielectricSide(float mean, float flux, GlassWalk walk) {
    float share = mean > 0.0 ? min(flux / mean, 1.0) : 0.0, rest = share > 0.0 ? (1.0 - share) / share : 0.0;
    float below = max(walk.place, 1e-6), above = 1.0 - walk.place;
    float slope = clamp(walk.slope, -min(1.0 / above, rest / below), min(1.0 / below, rest / above));
    return DielectricSide(mean, share, slope, walk.place);
}

// s of estimator.md.
float dielectricShare(DielectricSide side, float cosW) {
    float c = abs(cosW);
    float share = side.share * (1.0 + side.slope * (c * c * (2.0 - c) - side.place));
    return clamp(share, 0.0, 1.0);   // it may lie outside by rounding
}

DielectricLosses dielectricLosses(SurfaceBsdf b, vec3 wo) {
    DielectricSide none = DielectricSide(0.0, 0.0, 0.0, 0.0);
    if (!b.compensated) return DielectricLosses(0.0, 0.0, 0.0, none, none);
    GlassWalk walkX = glassWalk(b.table, b.roughness), walkY = glassWalk(dielectricOtherTable(b), b.roughness);
    float meanX = b.mean.z, meanY = albedoMean(dielectricOtherTable(b), b.roughness).z;
    // What crosses, seen from outside: the same both ways, but for eta^2.
    float eta2 = b.r.eta.x * b.r.eta.x, scaleX = b.front ? 1.0 : eta2, scaleY = b.front ? eta2 : 1.0;
    float share = b.front ? walkX.share : walkY.share, outside = b.front ? meanX : meanY;
    float flux = min(share * outside, eta2 * (b.front ? meanY : meanX));
    DielectricLosses l;
    l.x = dielectricSide(meanX, flux / scaleX, walkX);
    l.y = dielectricSide(meanY, flux / scaleY, walkY);
    l.lost = b.albedoO.z;
    l.probability = min(l.lost, 0.9);
    l.transmitted = dielectricShare(l.x, wo.z);
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
    DielectricLosses l = dielectricLosses(b, wo);
    float lostI = albedoLookup(through ? dielectricOtherTable(b) : b.table, b.roughness, wi).z;
    DielectricSide sideI = l.y;
    if (!through) sideI = l.x;
    float passedI = dielectricShare(sideI, wi.z), passedMean = sideI.mean * sideI.share;
    float share = through ? l.transmitted : 1.0 - l.transmitted;
    float shape = interreflection(l.lost, lostI * (through ? passedI : 1.0 - passedI),
                                  through ? passedMean : sideI.mean - passedMean);
    vec3 tint = through ? b.r.color / (b.eta * b.eta) : vec3(1.0);
    return mixValues(v, BsdfValue(tint * (share * shape), share * interreflectionPdf(lostSpread(b), wi.z)),
                     1.0 - l.probability);
}

// The direction beyond the facet; not to be asked for at total internal reflection.
vec3 refractThrough(vec3 wo, vec3 wm, float eta) {
    float cosO = dot(wo, wm), cosT = sqrt(max(1.0 - (1.0 - cosO) * (1.0 + cosO) / (eta * eta), 0.0));
    return (cosO / eta - cosT) * wm - wo / eta;
}

LobeSample dielectricSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    DielectricLosses l = dielectricLosses(b, wo);
    bool delta = b.facets.delta, multiple = chooseFirst(uLobe, l.probability);
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
