// The Phong distribution, with exponents 2/alpha^2 - 2 along the axes; local frame, normal +z. [Walter 07]

// Exponent at the azimuth of `at`, which need not have length 1.
float phongExponent(vec2 exponents, vec2 at) {
    vec2 a2 = at * at;
    float length2 = a2.x + a2.y;
    return length2 > 0.0 ? dot(exponents, a2) / length2 : exponents.x;
}

// Requires wm.z > 0.
float phongD(vec2 alpha, vec3 wm) {
    float e = phongExponent(2.0 / (alpha * alpha) - 2.0, wm.xy);
    return cosinePower(dot(wm.xy, wm.xy) / (wm.z * wm.z), e) * kInvPi / (alpha.x * alpha.y);
}

// Half vector of density proportional to cos^(exponent at its azimuth + more - 1): `more` is 2 for D cos, 1 for D.
vec3 phongSampleNormal(vec2 exponents, float more, vec2 u) {
    vec2 n = exponents + more, around = cosSinTurns(u.x);
    around = normalize(vec2(around.x, sqrt(n.x / n.y) * around.y));
    vec2 polar = cosSinOfPower(u.y, dot(n, around * around));
    return vec3(polar.y * around, polar.x);
}

vec3 phongSampleD(vec2 alpha, vec2 u) { return phongSampleNormal(2.0 / (alpha * alpha) - 2.0, 2.0, u); }
