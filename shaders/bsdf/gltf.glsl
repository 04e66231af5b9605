// glTF 2.0's metallic-roughness material. [glTF 2.0, appendix B] With kMultiscatter also what facets pass on among each
// other [Kulla 17], and a diffuse lobe that gets what the dielectric layer leaves it [Kelemen 01].

struct GltfBsdf {
    vec3 baseColor;
    float metallic;
    float alpha;      // roughness squared
    // Under kMultiscatter, of table 0: at wo (see albedoLookup) and mean.
    vec3 albedoO, mean;
};

float schlickWeight(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0), m2 = m * m;
    return m2 * m2 * m;
}

float fresnelDielectric(float cosine) { return kDielectricF0 + (1.0 - kDielectricF0) * schlickWeight(cosine); }

vec3 fresnelGltf(GltfBsdf b, float cosine) {
    vec3 metal = b.baseColor + (1.0 - b.baseColor) * schlickWeight(cosine);
    return mix(vec3(fresnelDielectric(cosine)), metal, b.metallic);
}

vec3 gltfDiffuse(GltfBsdf b, float cosM) {
    return (1.0 - b.metallic) * (1.0 - fresnelDielectric(cosM)) * b.baseColor * kInvPi;
}

// As glTF's table, the first, takes a roughness.
AlbedoRoughness gltfRoughness(float alpha) { return AlbedoRoughness(vec2(alpha), false); }

GltfBsdf makeGltfBsdf(vec3 baseColor, float metallic, float alpha, vec3 wo) {
    GltfBsdf b = GltfBsdf(baseColor, metallic, alpha, vec3(1.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0));
    if (kMultiscatter != 0u && alpha >= kDeltaAlpha) {
        b.albedoO = albedoLookup(0u, gltfRoughness(alpha), wo);
        b.mean = albedoMean(0u, gltfRoughness(alpha));
    }
    return b;
}

// Ms of estimator.md: share of interreflected light given back under Schlick's Fresnel term.
vec3 gltfReturned(GltfBsdf b, vec3 f0) { return interreflectedShare((1.0 + 20.0 * f0) / 21.0, b.mean.z); }

vec3 gltfReturned(GltfBsdf b) {
    return mix(gltfReturned(b, vec3(kDielectricF0)), gltfReturned(b, b.baseColor), b.metallic);
}

// R of estimator.md: what the dielectric layer reflects, of an albedo or of its mean.
float gltfLayerAlbedo(GltfBsdf b, vec3 albedo) {
    float returned = gltfReturned(b, vec3(kDielectricF0)).x;
    return kDielectricF0 * albedo.x + albedo.y + returned * albedo.z;
}

// 1 - R at cosine cosW, the table being `albedo` there.
float gltfLeft(GltfBsdf b, float cosW, vec3 albedo) {
    return 1.0 - (b.alpha < kDeltaAlpha ? fresnelDielectric(cosW) : gltfLayerAlbedo(b, albedo));
}

float gltfMeanLeft(GltfBsdf b) {
    return 1.0 - (b.alpha < kDeltaAlpha ? (1.0 + 20.0 * kDielectricF0) / 21.0 : gltfLayerAlbedo(b, b.mean));
}

// Diffuse lobe and interreflection.
vec3 gltfCoupled(GltfBsdf b, vec3 wo, vec3 wi) {
    bool delta = b.alpha < kDeltaAlpha;
    vec3 albedoI = delta ? vec3(1.0, 0.0, 0.0) : albedoLookup(0u, gltfRoughness(b.alpha), wi);
    float left = gltfLeft(b, wo.z, b.albedoO) * gltfLeft(b, wi.z, albedoI) / gltfMeanLeft(b);
    vec3 f = (1.0 - b.metallic) * b.baseColor * (left * kInvPi);
    if (!delta) f += gltfReturned(b) * interreflection(b.albedoO.z, albedoI.z, b.mean.z);
    return f;
}

// Probabilities of choosing the lobe of interreflection, and otherwise the specular one: their shares of the reflected
// luminance, seen along the normal. What the first choice leaves of a number is accurate however improbable it is, and
// interreflection can be next to nothing.
struct GltfChoices {
    float interreflection, specular;
};

float gltfShare(float first, float second) { return first + second > 0.0 ? first / (first + second) : 1.0; }

GltfChoices gltfChoices(GltfBsdf b, float cosO) {
    float s = luminance(fresnelGltf(b, cosO)), d = kPi * luminance(gltfDiffuse(b, cosO));
    if (kMultiscatter == 0u) return GltfChoices(0.0, gltfShare(s, d));
    bool delta = b.alpha < kDeltaAlpha;
    if (!delta) s = luminance(mix(vec3(kDielectricF0), b.baseColor, b.metallic) * b.albedoO.x + b.albedoO.y);
    float m = delta ? 0.0 : luminance(gltfReturned(b)) * b.albedoO.z;
    d = luminance((1.0 - b.metallic) * b.baseColor) * gltfLeft(b, cosO, b.albedoO);
    return GltfChoices(m > 0.0 ? gltfShare(m, s + d) : 0.0, gltfShare(s, d));
}

bool isDrawnOverHemisphere(GltfBsdf b) { return kHemisphere != kHemisphereBsdf && b.alpha >= kDeltaAlpha; }

// f of both lobes, without a delta lobe, and their joint pdf.
void gltfEvaluate(GltfBsdf b, vec3 wo, vec3 wi, out vec3 f, out float pdf) {
    f = vec3(0.0);
    pdf = 0.0;
    if (wo.z <= 0.0 || wi.z <= 0.0) return;
    vec3 wm = normalize(wo + wi);
    GltfChoices choices = gltfChoices(b, wo.z);
    float cosM = abs(dot(wo, wm));
    f = kMultiscatter != 0u ? gltfCoupled(b, wo, wi) : gltfDiffuse(b, cosM);
    pdf = wi.z * kInvPi * (1.0 - choices.specular);
    if (b.alpha >= kDeltaAlpha) {
        float d = ggxD(b.alpha, wm);
        f += fresnelGltf(b, cosM) * (d * ggxG2(b.alpha, wo.z, wi.z) / (4.0 * wo.z * wi.z));
        pdf += choices.specular * ggxReflectionPdf(b.alpha, wo.z, wm);
        if (kMultiscatter != 0u) pdf = mix(pdf, interreflectionPdf(b.alpha * b.alpha, wi.z), choices.interreflection);
    }
    if (isDrawnOverHemisphere(b)) pdf = hemispherePdf(wi.z);
}

// Direction by lobe choice and the lobe's own map; weight 0 where the direction is invalid. u.x is what choices have left
// of uLobe.
BsdfSample gltfSample(GltfBsdf b, vec3 wo, float uLobe, vec2 u) {
    BsdfSample s = BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    if (wo.z <= 0.0) return s;
    GltfChoices choices = gltfChoices(b, wo.z);
    bool interreflected = kMultiscatter != 0u && uLobe < choices.interreflection;
    bool specular = !interreflected && restOfChoice(uLobe, choices.interreflection) < choices.specular;
    bool delta = b.alpha < kDeltaAlpha;
    vec3 wm = delta ? vec3(0.0, 0.0, 1.0) : ggxSampleVisibleNormal(vec2(b.alpha), wo, u);
    s.wi = specular ? 2.0 * dot(wo, wm) * wm - wo : squareToCosineHemisphere(u);
    if (interreflected) s.wi = sampleInterreflection(b.alpha * b.alpha, u);
    if (isDrawnOverHemisphere(b)) s.wi = sampleHemisphere(vec2(uLobe, u.y));
    if (s.wi.z <= 0.0) return s;
    if (specular && delta) {
        s.weight = fresnelGltf(b, wo.z) / choices.specular;
        s.pdf = -1.0;
        return s;
    }
    vec3 f;
    gltfEvaluate(b, wo, s.wi, f, s.pdf);
    s.weight = s.pdf > 0.0 ? f * (s.wi.z / s.pdf) : vec3(0.0);
    return s;
}
