// Diffuse, and a cosine lobe around the mirror direction, normalised by (e + 2) / 2 pi. [Phong 75]
float phongModelShare(SurfaceBsdf b) { return specularShare(luminance(b.r.color), luminance(b.r.diffuse)); }

BsdfValue phongEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    vec3 r = vec3(-wo.xy, wo.z), across = cross(r, wi);
    float e = b.r.exponentX, c = dot(r, wi);
    float lobe = c > 0.0 ? cosinePower(dot(across, across) / (c * c), e) * (0.5 * kInvPi) : 0.0;
    BsdfValue specular = BsdfValue(b.r.color * ((e + 2.0) * lobe), (e + 1.0) * lobe);
    return mixValues(specular, diffuseValue(b.r.diffuse, wi), phongModelShare(b));
}

LobeSample phongSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    vec2 polar = cosSinOfPower(u.y, b.r.exponentX + 1.0);
    vec3 wi = toWorld(makeFrame(vec3(-wo.xy, wo.z)), vec3(polar.y * cosSinTurns(u.x), polar.x));
    return sampleLobe(uLobe < phongModelShare(b) ? wi : squareToCosineHemisphere(u));
}
