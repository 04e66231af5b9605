// Directions over the whole hemisphere: of integrator ao, and in place of a BSDF's own. [estimator.md, Hemisphere]
vec3 sampleHemisphere(vec2 u) {
    return kHemisphere == kHemisphereUniform ? squareToUniformHemisphere(u) : squareToCosineHemisphere(u);
}
float hemispherePdf(float cosine) { return kHemisphere == kHemisphereUniform ? 0.5 * kInvPi : max(cosine, 0.0) * kInvPi; }
