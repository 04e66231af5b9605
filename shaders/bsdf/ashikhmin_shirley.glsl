// An anisotropic lobe over a diffuse substrate that gets what the lobe leaves. [Ashikhmin 00, eqs. 4, 5, 8]
float ashikhminShirleyShare(SurfaceBsdf b, vec3 wo) {
    return specularShare(luminance(fresnelSchlick(wo.z, b.r.color)), luminance((1.0 - b.r.color) * b.r.diffuse));
}

// 1 - (1 - cos/2)^5
float ashikhminShirleyEntry(float cosW) {
    float m = 1.0 - 0.5 * cosW, m2 = m * m;
    return 1.0 - m2 * m2 * m;
}

BsdfValue ashikhminShirleyEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec2 n = vec2(b.r.exponentX, b.r.exponentY);
    vec3 wm = normalize(wo + wi);
    float cosM = dot(wo, wm), power = cosinePower(dot(wm.xy, wm.xy) / (wm.z * wm.z), phongExponent(n, wm.xy));
    float lobe = sqrt((n.x + 1.0) * (n.y + 1.0)) * (0.125 * kInvPi) * power / cosM;
    BsdfValue specular = BsdfValue(fresnelSchlick(cosM, b.r.color) * (lobe / max(wo.z, wi.z)), lobe);
    float entry = ashikhminShirleyEntry(wo.z) * ashikhminShirleyEntry(wi.z);
    BsdfValue substrate = diffuseValue(28.0 / 23.0 * entry * (1.0 - b.r.color) * b.r.diffuse, wi);
    return mixValues(specular, substrate, ashikhminShirleyShare(b, wo));
}

LobeSample ashikhminShirleySample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    vec3 wm = phongSampleNormal(vec2(b.r.exponentX, b.r.exponentY), 1.0, u);
    return sampleLobe(uLobe < ashikhminShirleyShare(b, wo) ? reflectAbout(wo, wm) : squareToCosineHemisphere(u));
}
