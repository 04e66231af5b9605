// glTF 2.0's metallic-roughness material. [glTF 2.0, appendix B]
// Local frame, normal +z. f excludes the cosine; pdf is per solid angle.

struct GltfBsdf {
    vec3 baseColor;
    float metallic;
    float alpha;      // roughness squared
};

struct BsdfSample {
    vec3 wi;
    vec3 weight;      // f |cos| / pdf
    float pdf;        // negative: a delta lobe
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

// Probability of choosing the specular lobe: its share of the reflected luminance, seen along the normal.
float gltfSpecularProbability(GltfBsdf b, float cosO) {
    float s = luminance(fresnelGltf(b, cosO)), d = kPi * luminance(gltfDiffuse(b, cosO));
    return s + d > 0.0 ? s / (s + d) : 1.0;
}

// f of both lobes, without a delta lobe, and their joint pdf.
void gltfEvaluate(GltfBsdf b, vec3 wo, vec3 wi, out vec3 f, out float pdf) {
    f = vec3(0.0);
    pdf = 0.0;
    if (wo.z <= 0.0 || wi.z <= 0.0) return;
    vec3 wm = normalize(wo + wi);
    float cosM = abs(dot(wo, wm)), pSpecular = gltfSpecularProbability(b, wo.z);
    f = gltfDiffuse(b, cosM);
    pdf = (1.0 - pSpecular) * wi.z * kInvPi;
    if (b.alpha >= kDeltaAlpha) {
        float d = ggxD(b.alpha, wm);
        f += fresnelGltf(b, cosM) * (d * ggxG2(b.alpha, wo.z, wi.z) / (4.0 * wo.z * wi.z));
        pdf += pSpecular * ggxReflectionPdf(b.alpha, wo.z, wm);
    }
}

// Direction by lobe choice and the lobe's own map; weight 0 where the direction is invalid.
BsdfSample gltfSample(GltfBsdf b, vec3 wo, float uLobe, vec2 u) {
    BsdfSample s = BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    if (wo.z <= 0.0) return s;
    float pSpecular = gltfSpecularProbability(b, wo.z);
    bool specular = uLobe < pSpecular, delta = b.alpha < kDeltaAlpha;
    vec3 wm = delta ? vec3(0.0, 0.0, 1.0) : ggxSampleVisibleNormal(b.alpha, wo, u);
    s.wi = specular ? 2.0 * dot(wo, wm) * wm - wo : squareToCosineHemisphere(u);
    if (s.wi.z <= 0.0) return s;
    if (specular && delta) {
        s.weight = fresnelGltf(b, wo.z) / pSpecular;
        s.pdf = -1.0;
        return s;
    }
    vec3 f;
    gltfEvaluate(b, wo, s.wi, f, s.pdf);
    s.weight = s.pdf > 0.0 ? f * (s.wi.z / s.pdf) : vec3(0.0);
    return s;
}
