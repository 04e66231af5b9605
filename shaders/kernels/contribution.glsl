// The exact film: a contribution is rounded once to fixed point and added to its path's integer sums. [DESIGN]

// value x 2^48, rounded, as three little-endian words. Requires 0 <= value < 2^40.
uvec3 toFixedPoint(float value) {
    uint bits = floatBitsToUint(value), exponent = (bits >> 23u) & 0xffu;
    uint mantissa = exponent == 0u ? 0u : (bits & 0x7fffffu) | 0x800000u;   // subnormals are far below 2^-49
    int shift = int(exponent) - 150 + int(kFilmFractionBits);
    if (shift < 0) {
        uint down = uint(-shift);
        return uvec3(down > 24u ? 0u : (mantissa + (1u << (down - 1u))) >> down, 0u, 0u);
    }
    uint words = uint(shift) >> 5u, by = uint(shift) & 31u;
    uint low = mantissa << by, high = by == 0u ? 0u : mantissa >> (32u - by);
    return words == 0u ? uvec3(low, high, 0u) : (words == 1u ? uvec3(0u, low, high) : uvec3(0u, 0u, low));
}

uvec3 addFixed(uvec3 a, uvec3 b) {
    uint carry0, carry1, carry2;
    uint x = uaddCarry(a.x, b.x, carry0);
    uint y = uaddCarry(a.y, b.y, carry1);
    y = uaddCarry(y, carry0, carry2);
    return uvec3(x, y, a.z + b.z + carry1 + carry2);
}

// NaN, Inf, below 0 (-0 is 0) and 2^40 or more, by exponent bits: comparisons with NaN may be optimised away.
bool isRefused(vec3 c) {
    uvec3 bits = mix(floatBitsToUint(c), uvec3(0u), equal(floatBitsToUint(c), uvec3(0x80000000u)));
    return any(greaterThanEqual(bits, uvec3((127u + 40u) << 23u)));
}

// Adds to the sums of a path. `first`: nothing was added before, the sums begin here; a camera ray's alpha with them.
void addContribution(uint path, vec3 c, bool first, bool alpha) {
    if (isRefused(c)) {
        atomicAdd(counters[kRefused], 1u);
        c = vec3(0.0);
    }
    uvec4 red = uvec4(0u), green = uvec4(0u), blue = uvec4(0u);
    if (!first) {
        red = loadState(kStateRed, path);
        green = loadState(kStateGreen, path);
        blue = loadState(kStateBlue, path);
    }
    storeState(kStateRed, path, uvec4(addFixed(red.xyz, toFixedPoint(c.r)), red.w + (alpha ? 1u : 0u)));
    storeState(kStateGreen, path, uvec4(addFixed(green.xyz, toFixedPoint(c.g)), 0u));
    storeState(kStateBlue, path, uvec4(addFixed(blue.xyz, toFixedPoint(c.b)), 0u));
}
