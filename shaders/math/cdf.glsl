// Inversion of a tabulated distribution.

// Smallest i in [0, count) with u < cdf[i]; four entries a step. x: i, y: cdf[i-1] (bits), z: cdf[i] (bits).
uvec3 searchCdf(uint base, uint count, float u) {
    uint words = (count + 3u) >> 2u, low = 0u, high = words - 1u;
    float before = 0.0;
    while (low < high) {  // the word whose last entry is the first above u
        uint middle = (low + high) >> 1u;
        float last = sceneWordFloat(base + middle).w;
        if (u < last) {
            high = middle;
        } else {
            low = middle + 1u;
            before = last;
        }
    }
    vec4 c = sceneWordFloat(base + low);
    uint i = u < c.x ? 0u : (u < c.y ? 1u : (u < c.z ? 2u : 3u));
    i = min(i, count - 1u - 4u * low);
    float previous = i == 0u ? before : c[i - 1u];
    return uvec3(4u * low + i, floatBitsToUint(previous), floatBitsToUint(c[i]));
}
