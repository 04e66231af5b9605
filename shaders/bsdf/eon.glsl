// Rough diffuse that preserves energy: Fujii's form of Oren-Nayar and what it loses. [Portsmouth 25]
const float kEonFujii = 0.5 - 2.0 / (3.0 * kPi), kEonMean = 2.0 / 3.0 - 28.0 / (15.0 * kPi);

// What the single term loses of uniform light from cosine mu, over A sigma.
float eonLoss(float mu) {
    float s = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0));
    float rest = s * mu * (1.0 + s + s * s) / (1.0 + s);     // (s / mu)(1 - s^3)
    float g = s * (atan2Accurate(s, mu) - s * mu) + (2.0 / 3.0) * (rest - s);
    return kEonFujii - g * kInvPi;
}

BsdfValue eonEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 rho = b.r.color;
    float sigma = b.r.sigma, a = 1.0 / (1.0 + kEonFujii * sigma), s = dot(wo.xy, wi.xy);
    float single = a * (1.0 + sigma * (s > 0.0 ? s / max(wo.z, wi.z) : s));
    float lostMean = a * sigma * (kEonFujii - kEonMean);     // 1 - mean albedo of the single term
    float lost = a * sigma * eonLoss(wo.z) * eonLoss(wi.z) / (kEonFujii - kEonMean);
    return diffuseValue(rho * (single + rho * (1.0 - lostMean) / (1.0 - rho * lostMean) * lost), wi);
}
LobeSample eonSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) { return sampleDiffuse(u); }
