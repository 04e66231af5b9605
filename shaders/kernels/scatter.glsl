// The BSDF of a vertex with the way in which its directions are drawn: its own, or over the hemisphere.
#include "bsdf/hemisphere.glsl"

bool isDrawnOverHemisphere(VertexBsdf b) { return kHemisphere != kHemisphereBsdf && hasPlainLobesOnly(b); }

void evaluateVertex(VertexBsdf b, vec3 wo, vec3 wi, out vec3 f, out float pdf) {
    evaluateBsdf(b, wo, wi, f, pdf);
    if (isDrawnOverHemisphere(b)) pdf = hemispherePdf(wi.z);
}

BsdfSample sampleVertex(VertexBsdf b, vec3 wo, float uLobe, vec2 u) {
    if (!isDrawnOverHemisphere(b)) return sampleBsdf(b, wo, uLobe, u);
    BsdfSample s;
    s.wi = sampleHemisphere(u);
    evaluateVertex(b, wo, s.wi, s.weight, s.pdf);
    s.weight = s.pdf > 0.0 ? s.weight * (s.wi.z / s.pdf) : vec3(0.0);
    return s;
}
