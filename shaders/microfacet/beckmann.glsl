// Beckmann-Spizzichino: slopes are Gaussian; local frame, normal +z. [Walter 07, Heitz 14]

// Requires wm.z > 0.
float beckmannD(vec2 alpha, vec3 wm) {
    vec2 s = wm.xy / (alpha * wm.z);
    float tan2 = dot(s, s), z2 = wm.z * wm.z;
    return tan2 < 80.0 ? exp(-tan2) * kInvPi / (alpha.x * alpha.y * z2 * z2) : 0.0;
}

// Smith's Lambda, exact. a = cot of the stretched angle. [Heitz 14, eq. 66]
float beckmannLambda(float a) {
    float b = min(a, 9.0);
    return 0.5 * (erfAccurate(b) - 1.0) + exp(-b * b) / (3.5449077 * b);
}

// The x-slope at u of the slopes visible from angle (cosO, sinO), along its azimuth: the root of a concave function of
// q = (1 + erf slope)/2, by four steps of Newton from the fitted start. [Jakob 14]
float beckmannVisibleSlope(float cosO, float sinO, float u) {
    const float root = 0.28209479;                                    // 1 / (2 sqrt pi)
    float cot = cosO < 5.0 * sinO ? cosO / sinO : 5.0, most = 0.5 + 0.5 * erfAccurate(cot);
    float target = u * (cosO * most + sinO * root * exp(-cot * cot));
    float theta = atan2Accurate(sinO, cosO);
    float power = 1.0 + theta * (-0.876 + theta * (0.4265 - 0.0594 * theta));
    float q = max(most * oneMinusExp(power * logOnePlus(-u)), 7.6e-13);
    for (uint i = 0u; i < 4u; ++i) {
        float x = erfInverse(q);
        float miss = q * cosO + sinO * root * exp(-x * x) - target;
        q = clamp(q - miss / (cosO - x * sinO), 0.125 * q, most);
    }
    return clamp(erfInverse(q), -5.0, cot);
}

vec3 beckmannSampleVisibleNormal(vec2 alpha, vec3 wo, vec2 u) {
    vec3 w = normalize(vec3(alpha * wo.xy, wo.z));
    float sinO = length(w.xy);
    vec2 axis = sinO > 0.0 ? w.xy / sinO : vec2(1.0, 0.0);
    vec2 s = vec2(beckmannVisibleSlope(w.z, sinO, u.x), erfInverse(u.y));
    return normalize(vec3(-alpha * vec2(s.x * axis.x - s.y * axis.y, s.x * axis.y + s.y * axis.x), 1.0));
}

// Of D cos: tan^2 in units of alpha.
float beckmannTan2(float u) { return -logOnePlus(-u); }
