// A surface of microfacets: distribution and masking by id. Local frame, normal +z; wo.z > 0, wm.z > 0.
#include "microfacet/fresnel.glsl"
#include "microfacet/beckmann.glsl"
#include "microfacet/phong.glsl"

struct Facets {
    vec2 alpha;
    uint distribution;   // kDistribution*
    uint masking;        // kMasking*
    bool delta;          // smooth: no density
};

Facets makeFacets(BsdfRecord r) {
    vec2 alpha = vec2(r.alphaX, r.alphaY);
    return Facets(max(alpha, vec2(kDeltaAlpha)), r.flags & kBsdfDistributionMask,
                  (r.flags >> kBsdfMaskingShift) & kBsdfMaskingMask, max(alpha.x, alpha.y) < kDeltaAlpha);
}

// Density of facet normals: its integral over cos is 1.
float facetsD(Facets f, vec3 wm) {
    if (wm.z <= 0.0) return 0.0;
    if (f.distribution == kDistributionGgx) return ggxD(f.alpha, wm);
    if (f.distribution == kDistributionBeckmann) return beckmannD(f.alpha, wm);
    return phongD(f.alpha, wm);
}

// Smith's Lambda; that of Beckmann where the distribution has none in closed form.
float facetsLambda(Facets f, vec3 w) {
    vec2 s = f.alpha * w.xy;
    float r2 = dot(s, s), z2 = w.z * w.z;
    if (f.distribution == kDistributionGgx) return 0.5 * (sqrt(1.0 + r2 / z2) - 1.0);
    return r2 > 0.0 ? beckmannLambda(sqrt(z2 / r2)) : 0.0;
}

// V-groove. [Torrance 67]
float grooveG1(vec3 w, vec3 wm) { return min(1.0, 2.0 * wm.z * abs(w.z) / abs(dot(w, wm))); }

float facetsG1(Facets f, vec3 w, vec3 wm) {
    return f.masking == kMaskingVGroove ? grooveG1(w, wm) : 1.0 / (1.0 + facetsLambda(f, w));
}

// Euler's Beta function, x and y from 1 on: Stirling's series two steps up, of whose powers none is large. [Abramowitz
// 64, 6.1.41] Error 3e-7 relative, and 1e-7 for every factor e below 1.
float betaFunction(float x, float y) {
    float s = x + y, a = x + 2.0, b = y + 2.0, ab = a + b;
    vec3 inverse = 1.0 / vec3(a, b, ab), inverse2 = inverse * inverse;
    vec3 series = inverse * (1.0 / 12.0 - inverse2 * (1.0 / 360.0 - inverse2 * (1.0 / 1260.0)));
    float power = -a * logOnePlus(b / a) - b * logOnePlus(a / b) + series.x + series.y - series.z;
    float steps = (s / x) * ((s + 1.0) / y) * ((s + 2.0) / (x + 1.0)) * ((s + 3.0) / (y + 1.0));
    return steps * sqrt(2.0 * kPi * ab / a / b) * exp(power);
}

// Masking and shadowing. Correlated: [Heitz 14, eq. 99], of opposite sides [Heitz 16, eq. 18].
float facetsG2(Facets f, vec3 wo, vec3 wi, vec3 wm) {
    if (f.masking == kMaskingVGroove) return min(grooveG1(wo, wm), grooveG1(wi, wm));
    float o = facetsLambda(f, wo), i = facetsLambda(f, wi);
    if (f.masking != kMaskingCorrelated) return 1.0 / ((1.0 + o) * (1.0 + i));
    return wo.z * wi.z < 0.0 ? betaFunction(1.0 + o, 1.0 + i) : 1.0 / (1.0 + o + i);
}

bool samplesVisible(Facets f) { return f.masking == kMaskingVGroove || f.distribution != kDistributionPhong; }

// Density of facetsSample, of facets that wo sees.
float facetsPdf(Facets f, vec3 wo, vec3 wm) {
    float shown = samplesVisible(f) ? facetsG1(f, wo, wm) * dot(wo, wm) / wo.z : wm.z;
    return dot(wo, wm) > 0.0 ? facetsD(f, wm) * shown : 0.0;
}

// Normal of density D cos.
vec3 facetsSampleD(Facets f, vec2 u) {
    if (f.distribution == kDistributionPhong) return phongSampleD(f.alpha, u);
    float tan2 = f.distribution == kDistributionGgx ? u.y / (1.0 - u.y) : beckmannTan2(u.y);
    return normalize(vec3(f.alpha * sqrt(tan2) * cosSinTurns(u.x), 1.0));
}

// `choose` of estimator.md: whether the first, of probability p; u goes on within what was chosen.
bool chooseFirst(inout float u, float p) {
    bool first = u < p;
    u = first ? u / p : (u - p) / (1.0 - p);
    return first;
}

// The facet of a groove that wo sees more of. [Heitz 14b]
vec3 chooseGrooveSide(vec3 wo, vec3 wm, inout float uChoice) {
    vec3 mirrored = vec3(-wm.xy, wm.z);
    float a = max(dot(wo, wm), 0.0), b = max(dot(wo, mirrored), 0.0);
    return chooseFirst(uChoice, a + b > 0.0 ? a / (a + b) : 1.0) ? wm : mirrored;
}

// A facet normal as seen from wo. Of the phong distribution with Smith's masking: D cos.
vec3 facetsSample(Facets f, vec3 wo, vec2 u, inout float uChoice) {
    if (f.masking == kMaskingVGroove) return chooseGrooveSide(wo, facetsSampleD(f, u), uChoice);
    if (f.distribution == kDistributionGgx) return ggxSampleVisibleNormal(f.alpha, wo, u);
    if (f.distribution == kDistributionBeckmann) return beckmannSampleVisibleNormal(f.alpha, wo, u);
    return phongSampleD(f.alpha, u);
}
