// Maps from the unit square, by the names of estimator.md.

// Concentric map of the square to the unit disk. [Shirley 97]
vec2 squareToDisk(vec2 u) {
    vec2 p = 2.0 * u - 1.0;
    if (p.x == 0.0 && p.y == 0.0) return vec2(0.0);
    bool xMajor = abs(p.x) > abs(p.y);
    float r = xMajor ? p.x : p.y;
    float turns = xMajor ? 0.125 * (p.y / p.x) : 0.25 - 0.125 * (p.x / p.y);
    return r * cosSinTurns(turns);
}

// Cosine-weighted hemisphere around +z; pdf cos/pi.
vec3 squareToCosineHemisphere(vec2 u) {
    vec2 d = squareToDisk(u);
    return vec3(d, sqrt(max(1.0 - dot(d, d), 0.0)));
}

// Uniform hemisphere around +z; pdf 1/(2 pi).
vec3 squareToUniformHemisphere(vec2 u) { return vec3(sqrt(max(1.0 - u.y * u.y, 0.0)) * cosSinTurns(u.x), u.y); }

// What choosing the first of two by u < p leaves of u, from 0 to below 1. [Shirley 96]
float restOfChoice(float u, float p) { return min(u < p ? u / p : (u - p) / (1.0 - p), kBelowOne); }
