// Logarithm and exponential where the language's own lose digits: near 1 and near 0.

// ln y, given y - 1 as well (exact where y is near 1). Requires y > 0. By the odd series of atanh; error 2e-7 relative.
float logNear(float y, float yMinusOne) {
    int e = (int(floatBitsToUint(y)) - 0x3f3504f3) >> 23;                   // y = m 2^e, m in [sqrt 1/2, sqrt 2)
    float m = uintBitsToFloat(floatBitsToUint(y) - (uint(e) << 23u));
    float s = e == 0 ? yMinusOne / (2.0 + yMinusOne) : (m - 1.0) / (m + 1.0), s2 = s * s;
    float series = 2.0 * s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0 + s2 * (1.0 / 9.0)))));
    return float(e) * 0.69314718056 + series;
}

// ln(1 + t). Requires t > -1.
float logOnePlus(float t) { return logNear(1.0 + t, t); }

// 1 - exp(y). Requires y <= 0.
float oneMinusExp(float y) {
    float series = 1.0 + y * (1.0 / 8.0);
    series = 1.0 + y * (1.0 / 7.0) * series;
    series = 1.0 + y * (1.0 / 6.0) * series;
    series = 1.0 + y * (1.0 / 5.0) * series;
    series = 1.0 + y * (1.0 / 4.0) * series;
    series = 1.0 + y * (1.0 / 3.0) * series;
    series = 1.0 + y * (1.0 / 2.0) * series;
    return y > -0.5 ? -y * series : 1.0 - exp(y);
}

// cos^e of the angle whose squared tangent is given: exact where the cosine is near 1 and e is large.
float cosinePower(float tan2, float e) { return exp(-0.5 * e * logOnePlus(tan2)); }

// (cos, sin) of the angle with cos^n = 1 - u. Requires u < 1.
vec2 cosSinOfPower(float u, float n) {
    float l = logOnePlus(-u) / n;
    return vec2(exp(l), sqrt(oneMinusExp(2.0 * l)));
}
