// The BSDF of a group, over the generated evaluateModel and sampleModel.

bool transmits(SurfaceBsdf b) { return b.model == kDielectricModel; }

bool isDrawnOverHemisphere(SurfaceBsdf b) {
    if (kHemisphere == kHemisphereBsdf || b.model == kMirrorModel || transmits(b)) return false;
    bool ofFacets = b.model == kConductorModel || b.model == kPlasticModel || b.model == kTorranceSparrowModel;
    return !(ofFacets && b.facets.delta);
}

// f of the lobes that are no deltas, and their joint pdf.
void evaluateBsdf(SurfaceBsdf b, vec3 wo, vec3 wi, out vec3 f, out float pdf) {
    BsdfValue v = kNoValue;
    if (wo.z > 0.0 && (wi.z > 0.0 || (wi.z < 0.0 && transmits(b)))) v = evaluateModel(b, wo, wi);
    f = v.f;
    pdf = isDrawnOverHemisphere(b) ? hemispherePdf(wi.z) : v.pdf;
}

// A direction by lobe choice and the lobe's own map; weight 0 where the direction is invalid.
BsdfSample sampleBsdf(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) {
    BsdfSample s = BsdfSample(vec3(0.0, 0.0, 1.0), vec3(0.0), 0.0);
    if (wo.z <= 0.0) return s;
    LobeSample lobe = sampleModel(b, wo, uLobe, u);
    if (isDrawnOverHemisphere(b)) lobe = sampleLobe(sampleHemisphere(u));
    s.wi = lobe.wi;
    if (lobe.delta) {
        s.weight = lobe.weight;
        s.pdf = -1.0;
        return s;
    }
    vec3 f;
    evaluateBsdf(b, wo, s.wi, f, s.pdf);
    s.weight = s.pdf > 0.0 ? f * (abs(s.wi.z) / s.pdf) : vec3(0.0);
    return s;
}
