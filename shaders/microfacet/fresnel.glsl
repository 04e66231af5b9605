// Share of unpolarised light that a smooth interface reflects. cosO > 0: between wo and the normal.

// eta = ior(beyond) / ior(on the side of wo); 1 at total internal reflection. [Walter 07, eq. 22]
float fresnelDielectricExact(float cosO, float eta) {
    float sin2T = max((1.0 - cosO) * (1.0 + cosO), 0.0) / (eta * eta);
    if (sin2T >= 1.0) return 1.0;
    float cosT = sqrt(1.0 - sin2T);
    float parallel = (eta * cosO - cosT) / (eta * cosO + cosT);
    float perpendicular = (cosO - eta * cosT) / (cosO + eta * cosT);
    return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

// Complex index eta + i k. [Born 99, §14.2]
vec3 fresnelConductor(float cosO, vec3 eta, vec3 k) {
    float cos2 = cosO * cosO, sin2 = max((1.0 - cosO) * (1.0 + cosO), 0.0);
    vec3 t = eta * eta - k * k - sin2, etaK = eta * k;
    vec3 modulus = sqrt(t * t + 4.0 * etaK * etaK);          // a^2 + b^2
    // a^2, without the difference of like numbers
    vec3 a2 = mix(2.0 * etaK * etaK / max(modulus - t, vec3(1e-30)), 0.5 * (modulus + t), greaterThanEqual(t, vec3(0.0)));
    vec3 twiceACos = 2.0 * cosO * sqrt(a2);
    vec3 perpendicular = (modulus + cos2 - twiceACos) / (modulus + cos2 + twiceACos);
    vec3 even = cos2 * modulus + sin2 * sin2, odd = twiceACos * sin2;
    return 0.5 * perpendicular * (1.0 + (even - odd) / (even + odd));
}

vec3 fresnelSchlick(float cosO, vec3 f0) {
    float m = clamp(1.0 - cosO, 0.0, 1.0), m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

// Of a material: kBsdfMetal tells which.
vec3 fresnelOf(BsdfRecord r, float cosO) {
    return (r.flags & kBsdfMetal) != 0u ? fresnelConductor(cosO, r.eta, r.k) : vec3(fresnelDielectricExact(cosO, r.eta.x));
}
