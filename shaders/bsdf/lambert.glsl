// Ideal diffuse.
BsdfValue lambertEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) { return diffuseValue(b.r.color, wi); }
LobeSample lambertSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) { return sampleDiffuse(u); }
