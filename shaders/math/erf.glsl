// The error function and its inverse, by polynomials fitted at Chebyshev nodes.

// Error below 2e-7.
float erfAccurate(float x) {
    float ax = abs(x), y = x * x;
    float p = 7.8758751e-5 * y - 8.0168643e-4;
    p = p * y + 5.1890874e-3;
    p = p * y - 2.6854212e-2;
    p = p * y + 1.1283595e-1;
    p = p * y - 3.7612627e-1;
    p = p * y + 1.1283792;
    float t = 2.0 / (2.0 + ax);                  // erfc(x) = exp(-x^2) q(t) for x in [1, 4] and, as small, beyond
    float q = 1.2085243e-1 * t - 4.7652527e-1;
    q = q * t + 5.7126518e-1;
    q = q * t - 1.1020829e-1;
    q = q * t + 3.5103032e-1;
    q = q * t + 2.5875137e-1;
    q = q * t + 2.8506162e-1;
    q = q * t - 1.6423639e-4;
    float tail = 1.0 - exp(-y) * q;
    return ax < 1.0 ? x * p : (x < 0.0 ? -tail : tail);
}

// The inverse of erf at 2q - 1, within [-5, 5]: near q = 0 an argument of erf itself would have no digits left.
// Polynomials in w = -ln(1 - (2q - 1)^2) or its root, as in [Giles 11]; error below 2e-6.
float erfInverse(float q) {
    float b = 2.0 * q - 1.0, rest = 4.0 * q * (1.0 - q);
    float w = -logNear(max(rest, 3e-12), -b * b);
    float p = -8.9319260e-9 * w + 2.2430430e-7;
    p = p * w - 2.0082713e-6;
    p = p * w + 4.1506632e-6;
    p = p * w + 4.4048804e-5;
    p = p * w - 1.2653947e-4;
    p = p * w - 2.3352706e-3;
    p = p * w + 1.1549165e-2;
    p = p * w + 2.3201371e-1;
    p = p * w + 8.8622692e-1;
    float s = sqrt(max(w, 0.0)) - 3.0;
    float r = 4.5409716e-6 * s - 4.2207956e-6;
    r = r * s - 2.1058925e-4;
    r = r * s + 1.2284364e-3;
    r = r * s - 3.3415553e-3;
    r = r * s + 5.7256744e-3;
    r = r * s - 7.7286229e-3;
    r = r * s + 9.4506582e-3;
    r = r * s + 1.0016833;
    r = r * s + 2.8329764;
    return clamp((w < 5.0 ? p : r) * b, -5.0, 5.0);
}
