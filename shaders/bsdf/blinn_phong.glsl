// Diffuse, and a cosine lobe around the half vector. Normalised as the lecture does, which gains energy, or so
// that the directional albedo at normal incidence is 1. [Giesen 09]
float blinnPhongShare(SurfaceBsdf b) { return specularShare(luminance(b.r.color), luminance(b.r.diffuse)); }

BsdfValue blinnPhongEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 wm = normalize(wo + wi);
    float e = b.r.exponentX, power = cosinePower(dot(wm.xy, wm.xy) / (wm.z * wm.z), e);
    float conserving = (e + 2.0) * (e + 4.0) / (8.0 * kPi * (exp2(-0.5 * e) + e)), lecture = (e + 2.0) * (0.5 * kInvPi);
    float normalization = (b.r.flags & kBsdfConserving) != 0u ? conserving : lecture;
    float pdf = (e + 1.0) * (0.5 * kInvPi) * power / (4.0 * dot(wo, wm));
    BsdfValue specular = BsdfValue(b.r.color * (normalization * power), pdf);
    return mixValues(specular, diffuseValue(b.r.diffuse, wi), blinnPhongShare(b));
}

LobeSample blinnPhongSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    vec2 polar = cosSinOfPower(u.y, b.r.exponentX + 1.0);
    vec3 wm = vec3(polar.y * cosSinTurns(u.x), polar.x);
    return sampleLobe(uLobe < blinnPhongShare(b) ? reflectAbout(wo, wm) : squareToCosineHemisphere(u));
}
