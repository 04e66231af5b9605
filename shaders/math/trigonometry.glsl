// Trigonometry of our own: Vulkan allows sin and cos 2^-11 and atan 4096 ulp. [Moshier 89]

// (cos, sin) of `turns` full turns, any finite value of moderate size. Error below 1e-7.
vec2 cosSinTurns(float turns) {
    float quarter = floor(4.0 * turns + 0.5);
    float r = 2.0 * kPi * (turns - 0.25 * quarter), r2 = r * r;
    float s = r + r * r2 * (-1.0 / 6.0 + r2 * (1.0 / 120.0 + r2 * (-1.0 / 5040.0 + r2 * (1.0 / 362880.0))));
    float c = 1.0 + r2 * (-0.5 + r2 * (1.0 / 24.0 + r2 * (-1.0 / 720.0 + r2 * (1.0 / 40320.0))));
    uint k = uint(int(quarter)) & 3u;
    vec2 rotated = (k & 1u) != 0u ? vec2(-s, c) : vec2(c, s);
    return (k & 2u) != 0u ? -rotated : rotated;
}

// Angle of (x, y) in (-pi, pi], 0 at the origin. Error below 3e-7.
float atan2Accurate(float y, float x) {
    float ax = abs(x), ay = abs(y);
    float small = min(ax, ay), large = max(ax, ay);
    float ratio = large > 0.0 ? small / large : 0.0;       // in [0, 1]
    bool reduce = ratio > 0.41421356;                      // tan(pi/8)
    float z = reduce ? (ratio - 1.0) / (ratio + 1.0) : ratio, z2 = z * z;
    float angle = z + z * z2 * (-3.33329491539e-1 + z2 * (1.99777106478e-1 + z2 * (-1.38776856032e-1 +
                                                                                z2 * 8.05374449538e-2)));
    if (reduce) angle += 0.25 * kPi;
    if (ay > ax) angle = 0.5 * kPi - angle;
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

// Arc cosine by way of atan2: accurate at both ends.
float acosAccurate(float c) { return atan2Accurate(sqrt(max((1.0 - c) * (1.0 + c), 0.0)), c); }
