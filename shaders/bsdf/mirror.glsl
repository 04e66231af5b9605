// Ideal mirror.
BsdfValue mirrorEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) { return kNoValue; }
LobeSample mirrorSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    return sampleDelta(vec3(-wo.xy, wo.z), b.r.color);
}
