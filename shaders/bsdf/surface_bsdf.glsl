// A BSDF of the groups microfacet and classic at one point: its record with the maps applied, and what depends on wo.
#include "math/exponential.glsl"
#include "math/erf.glsl"
#include "microfacet/ggx.glsl"
#include "microfacet/facets.glsl"
#include "microfacet/albedo.glsl"

// f and pdf of all lobes that are no deltas.
struct BsdfValue {
    vec3 f;
    float pdf;
};

// A direction; of a delta lobe with its weight.
struct LobeSample {
    vec3 wi;
    bool delta;
    vec3 weight;
};

struct SurfaceBsdf {
    BsdfRecord r;        // maps applied
    uint model;
    Facets facets;
    bool compensated;    // interreflection between facets counts
    uint table;          // of the side of wo; kNone: none
    AlbedoRoughness roughness;   // as its tables take it
    vec3 albedoO;        // at wo: albedoLookup
    vec3 mean;           // of the side of wo
    float eta;           // ior beyond / ior on the side of wo
    bool front;
};

// Plastic reads its table whether interreflection counts or not.
const bool kReadsAlbedo = kMultiscatter != 0u || (kBsdfModels & (1u << kPlasticModel)) != 0u;
const BsdfValue kNoValue = BsdfValue(vec3(0.0), 0.0);

bool multipliesDiffuse(uint model) {
    return model == kPhongModel || model == kBlinnPhongModel || model == kPlasticModel || model == kCookTorranceModel ||
           model == kAshikhminShirleyModel;
}

// `color` of base colour map and vertex colours, `roughness` of the metallic-roughness map.
SurfaceBsdf makeSurfaceBsdf(BsdfRecord r, uint model, vec3 color, float roughness, bool front, vec3 wo) {
    SurfaceBsdf b;
    if (multipliesDiffuse(model)) r.diffuse *= color;
    else r.color *= color;
    r.alphaX *= roughness;
    r.alphaY *= roughness;
    r.sigma *= roughness;
    b.r = r;
    b.model = model;
    b.facets = makeFacets(r);
    if (model == kTorranceSparrowModel || model == kCookTorranceModel) b.facets.masking = kMaskingVGroove;
    if (model == kCookTorranceModel) b.facets.delta = false;
    bool dielectric = model == kDielectricModel;
    if (dielectric && r.eta.x == 1.0) b.facets.delta = true;
    b.front = front || !dielectric;
    b.eta = b.front ? r.eta.x : 1.0 / r.eta.x;
    bool tabled = r.table != kNone && !b.facets.delta;
    b.compensated = kMultiscatter != 0u && tabled;
    b.table = b.front ? r.table : r.table + kAlbedoTableWords;
    b.roughness = AlbedoRoughness(b.facets.alpha, (r.flags & kBsdfAzimuthTable) != 0u);
    b.albedoO = vec3(1.0, 0.0, 0.0);
    b.mean = vec3(1.0, 0.0, 0.0);
    if (kReadsAlbedo && tabled) {
        b.albedoO = albedoLookup(b.table, b.roughness, wo);
        b.mean = albedoMean(b.table, b.roughness);
    }
    return b;
}

// Probability of the specular lobe, of the luminances of both.
float specularShare(float s, float d) { return s + d > 0.0 ? s / (s + d) : 1.0; }

vec3 reflectAbout(vec3 wo, vec3 wm) { return 2.0 * dot(wo, wm) * wm - wo; }

LobeSample sampleLobe(vec3 wi) { return LobeSample(wi, false, vec3(0.0)); }
// c of estimator.md, Interreflection.
float lostSpread(SurfaceBsdf b) { return b.facets.alpha.x * b.facets.alpha.y; }

LobeSample sampleDiffuse(vec2 u) { return sampleLobe(squareToCosineHemisphere(u)); }
LobeSample sampleDelta(vec3 wi, vec3 weight) { return LobeSample(wi, true, weight); }

BsdfValue diffuseValue(vec3 albedo, vec3 wi) { return BsdfValue(albedo * kInvPi, wi.z * kInvPi); }
BsdfValue mixValues(BsdfValue specular, BsdfValue diffuse, float pSpecular) {
    return BsdfValue(specular.f + diffuse.f, pSpecular * specular.pdf + (1.0 - pSpecular) * diffuse.pdf);
}

// F D G2 / (4 cosO cosI) of mirror facets. [Walter 07, eq. 20]
BsdfValue facetReflection(SurfaceBsdf b, vec3 wo, vec3 wi, vec3 fresnel, vec3 wm) {
    float d = facetsD(b.facets, wm) * facetsG2(b.facets, wo, wi, wm);
    return BsdfValue(fresnel * (d / (4.0 * wo.z * wi.z)), facetsPdf(b.facets, wo, wm) / (4.0 * dot(wo, wm)));
}
