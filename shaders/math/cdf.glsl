// Inversion of a tabulated distribution.

// Smallest i in [0, count) with u < cdf[i]; four entries a step. x: i, y: cdf[i-1] (bits), z: cdf[i] (bits).
// `steps` halvings at most lead to one word: ceil(log2(count / 4)) suffice, more change nothing. Requires u < 1.
uvec3 searchCdf(uint base, uint count, float u, uint steps) {
    uint words = (count + 3u) >> 2u, low = 0u, high = words - 1u;
    float before = 0.0;
    for (uint step = 0u; step < steps; ++step) {  // the word whose last entry is the first above u
        uint middle = (low + high) >> 1u;
        float last = sceneWordFloat(base + middle).w;
        bool below = u < last || low == high;
        high = below ? middle : high;
        low = below ? low : middle + 1u;
        before = below ? before : last;
    }
    vec4 c = sceneWordFloat(base + low);
    uint i = u < c.x ? 0u : (u < c.y ? 1u : (u < c.z ? 2u : 3u));
    i = min(i, count - 1u - 4u * low);
    float previous = i == 0u ? before : c[i - 1u];
    return uvec3(4u * low + i, floatBitsToUint(previous), floatBitsToUint(c[i]));
}
