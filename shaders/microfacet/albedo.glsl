// Albedo tables: what a microfacet surface reflects and transmits of uniform light, over direction and roughness, and
// the lobe of what it loses. [estimator.md, Microfacets and Interreflection]

struct AlbedoRoughness {
    vec2 alpha;     // each at least kDeltaAlpha
    bool azimuth;   // rows stand for azimuths, else for roughnesses
};

// g of estimator.md.
float meanAlpha(AlbedoRoughness r) { return sqrt(r.alpha.x * r.alpha.y); }

// Place of `x` in [0, 1] among kAlbedoSide entries: index of the lower one of two, weight of the upper.
float albedoPlace(float x, out uint index) {
    float at = clamp(x, 0.0, 1.0) * float(kAlbedoSide - 1u);
    index = min(uint(at), kAlbedoSide - 2u);
    return at - float(index);
}

float albedoRow(AlbedoRoughness r) { return (sqrt(sqrt(meanAlpha(r))) - 0.1) * (1.0 / 0.9); }
float albedoAzimuthRow(vec3 w) { return atan2Accurate(abs(w.y), abs(w.x)) * (2.0 * kInvPi); }

float albedoColumn(AlbedoRoughness r, vec3 w) {
    float mu = abs(w.z), q = r.azimuth ? length(r.alpha * w.xy) : meanAlpha(r) * length(w.xy);
    return 0.5 * (sqrt(mu) + sqrt(sqrt(mu / (mu + q))));
}

// Of an albedo's corner the roots of (second, lost).
vec2 unpackAlbedo(uint word) { return vec2(float(word & 0xffffu), float(word >> 16u)) * (1.0 / 65535.0); }

// (first, second, lost), of which the first is what the others leave.
vec3 wholeAlbedo(vec2 others) { return vec3(max(1.0 - others.x - others.y, 0.0), others); }

// Of the table at `table` towards w, on either side.
vec3 albedoLookup(uint table, AlbedoRoughness r, vec3 w) {
    uint i, j;
    float x = albedoPlace(albedoColumn(r, w), i), y = albedoPlace(r.azimuth ? albedoAzimuthRow(w) : albedoRow(r), j);
    uvec4 cell = sceneWord(scene.albedoTables + table + j * (kAlbedoSide - 1u) + i);
    vec2 a = mix(mix(unpackAlbedo(cell.x), unpackAlbedo(cell.y), x), mix(unpackAlbedo(cell.z), unpackAlbedo(cell.w), x), y);
    return wholeAlbedo(a * a);
}

// Its hemispherical mean.
vec3 albedoMean(uint table, AlbedoRoughness r) {
    uint j;
    float y = albedoPlace(albedoRow(r), j), g = meanAlpha(r);
    vec4 cell = sceneWordFloat(scene.albedoTables + table + (kAlbedoSide - 1u) * (kAlbedoSide - 1u) + j);
    return wholeAlbedo(vec2(mix(cell.z, cell.w, y), g * g * mix(cell.x, cell.y, y)));
}

// What a random walk tells of light that more than one facet meets. [estimator.md, Interreflection]
struct MetalWalk {
    vec2 cosines, escapes;   // c0 and c1, e0 and e1
    float place;             // m
};
struct GlassWalk {
    float share, slope, place;   // rho, b, m
};

// First of the two rows that a roughness lies between; y: how far it is to the second.
uint walkRow(uint table, AlbedoRoughness r, out float y) {
    uint j;
    y = albedoPlace(albedoRow(r), j);
    return scene.albedoTables + table + kAlbedoSide * (kAlbedoSide - 1u) + j;
}

MetalWalk metalWalk(uint table, AlbedoRoughness r) {
    float y;
    uint at = walkRow(table, r, y);
    uvec4 a = sceneWord(at), b = sceneWord(at + 1u);
    return MetalWalk(mix(unpackAlbedo(a.x), unpackAlbedo(b.x), y), mix(unpackAlbedo(a.y), unpackAlbedo(b.y), y),
                     mix(uintBitsToFloat(a.z), uintBitsToFloat(b.z), y));
}

GlassWalk glassWalk(uint table, AlbedoRoughness r) {
    float y;
    uint at = walkRow(table, r, y);
    vec4 walk = mix(sceneWordFloat(at), sceneWordFloat(at + 1u), y);
    return GlassWalk(walk.x, walk.y, walk.z);
}

// Share of interreflected light that a conductor gives back, of its mean Fresnel term and of what is lost. [Kulla 17]
vec3 interreflectedShare(vec3 fresnelMean, float lostMean) {
    return fresnelMean * fresnelMean * (1.0 - lostMean) / (1.0 - fresnelMean * lostMean);
}

// (1 - E(wo)) (1 - E(wi)) / (pi (1 - mean)), of what is lost; 0 where nothing is.
float interreflection(float lostO, float lostI, float lostMean) {
    return lostMean > 0.0 ? lostO * lostI * kInvPi / lostMean : 0.0;
}

// Density of sampleInterreflection; c = g^2.
float interreflectionPdf(float c, float cosI) {
    float mu = abs(cosI);
    return mu * kInvPi / ((mu * mu + c) * logOnePlus(1.0 / c));
}

// A direction where light is lost, about a cosine of the roughness.
vec3 sampleInterreflection(float c, vec2 u) {
    float y = u.y * logOnePlus(1.0 / c);
    float mu2 = min(c * exp(y) * oneMinusExp(-y), 1.0);     // c ((1 + 1/c)^u1 - 1)
    return vec3(sqrt(1.0 - mu2) * cosSinTurns(u.x), sqrt(mu2));
}
