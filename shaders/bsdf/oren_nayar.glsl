// Rough diffuse: Lambertian facets in V-grooves, masked and shadowed, with light that two facets pass on. The full model,
// both terms. [Oren 94, eqs. 30 to 33]
BsdfValue orenNayarEvaluate(SurfaceBsdf b, vec3 wo, vec3 wi) {
    float sinO = length(wo.xy), sinI = length(wi.xy), sines = sinO * sinI;
    float cosPhi = sines > 0.0 ? clamp(dot(wo.xy, wi.xy) / sines, -1.0, 1.0) : 1.0;
    float thetaO = atan2Accurate(sinO, wo.z), thetaI = atan2Accurate(sinI, wi.z);
    float larger = max(thetaO, thetaI), smaller = min(thetaO, thetaI);          // alpha and beta of the paper
    float sinLarger = max(sinO, sinI), tanSmaller = min(sinO, sinI) / max(wo.z, wi.z);
    float tanHalf = (sinO + sinI) / (wo.z + wi.z);                              // of (alpha + beta) / 2
    float s2 = b.r.sigma * b.r.sigma, slope = 2.0 * smaller * kInvPi, product = 4.0 * larger * smaller * kInvPi * kInvPi;
    float c1 = 1.0 - 0.5 * s2 / (s2 + 0.33);
    float c2 = 0.45 * s2 / (s2 + 0.09) * (sinLarger - (cosPhi >= 0.0 ? 0.0 : slope * slope * slope));
    float c3 = 0.125 * s2 / (s2 + 0.09) * product * product;
    float direct = c1 + cosPhi * c2 * tanSmaller + (1.0 - abs(cosPhi)) * c3 * tanHalf;
    float twice = 0.17 * s2 / (s2 + 0.13) * (1.0 - cosPhi * slope * slope);
    return diffuseValue(max(b.r.color * (direct + b.r.color * twice), vec3(0.0)), wi);   // the fit goes below 0 at grazing
}
LobeSample orenNayarSample(SurfaceBsdf b, vec3 wo, float uLobe, vec2 u) { return sampleDiffuse(u); }
