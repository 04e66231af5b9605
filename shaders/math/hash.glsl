// Integer hash: four uints in, four out. [Jarzynski 20]
uvec4 hash(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Upper 24 bits as a float in [0,1): exact, never 1.
float toUnit(uint bits) { return float(bits >> 8u) * 5.9604644775390625e-8; }
