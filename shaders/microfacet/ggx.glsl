// GGX (Trowbridge-Reitz); local frame, normal +z. [Walter 07, Heitz 14]

// Written without 1 - cos^2, which would cancel at small alpha.
float ggxD(float alpha, vec3 wm) {
    float a2 = alpha * alpha, t = a2 * wm.z * wm.z + dot(wm.xy, wm.xy);
    return a2 * kInvPi / (t * t);
}

// Of two alphas.
float ggxD(vec2 alpha, vec3 wm) {
    vec2 s = wm.xy / alpha;
    float t = dot(s, s) + wm.z * wm.z;
    return kInvPi / (alpha.x * alpha.y * t * t);
}

// Smith's Lambda. [Heitz 14, eq. 72]
float ggxLambda(float alpha, float cosW) {
    float c2 = cosW * cosW;
    return 0.5 * (sqrt(1.0 + alpha * alpha * max(1.0 - c2, 0.0) / c2) - 1.0);
}

float ggxG1(float alpha, float cosW) { return 1.0 / (1.0 + ggxLambda(alpha, cosW)); }

// Height-correlated masking and shadowing. [Heitz 14, eq. 99]
float ggxG2(float alpha, float cosO, float cosI) {
    return 1.0 / (1.0 + ggxLambda(alpha, cosO) + ggxLambda(alpha, cosI));
}

// Density of the visible normal's reflection wi: D G1(wo) / (4 cosO). [Heitz 18, eq. 17]
float ggxReflectionPdf(float alpha, float cosO, vec3 wm) {
    return ggxD(alpha, wm) * ggxG1(alpha, cosO) / (4.0 * cosO);
}

// Visible normal by spherical caps. [Dupuy 23, listing 3]
vec3 ggxSampleVisibleNormal(vec2 alpha, vec3 wo, vec2 u) {
    vec3 w = normalize(vec3(wo.xy * alpha, wo.z));
    float z = (1.0 - u.y) * (1.0 + w.z) - w.z;
    float r = sqrt(clamp((1.0 - z) * (1.0 + z), 0.0, 1.0));
    vec3 h = vec3(r * cosSinTurns(u.x), z) + w;
    return normalize(vec3(h.xy * alpha, h.z));
}
