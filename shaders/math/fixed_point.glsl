// Integers of 96 bits with kFilmFractionBits of fraction, as three little-endian words. [estimator.md, Numbers]

// value x 2^48, rounded. Requires 0 <= value < 2^40.
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

// Modulo 2^96, so numbers in two's complement add up as well.
uvec3 addFixed(uvec3 a, uvec3 b) {
    uint carry0, carry1, carry2;
    uint x = uaddCarry(a.x, b.x, carry0);
    uint y = uaddCarry(a.y, b.y, carry1);
    y = uaddCarry(y, carry0, carry2);
    return uvec3(x, y, a.z + b.z + carry1 + carry2);
}

// Two's complement: the magnitude is rounded as in toFixedPoint. Requires |value| < 2^40.
uvec3 toSignedFixedPoint(float value) {
    uvec3 magnitude = toFixedPoint(abs(value));
    return value < 0.0 ? addFixed(~magnitude, uvec3(1u, 0u, 0u)) : magnitude;
}

// NaN, Inf or a magnitude of 2^exponent or more, by exponent bits: comparisons with NaN may be optimised away.
bool isBeyond(vec3 v, uint exponent) {
    return any(greaterThanEqual(floatBitsToUint(v) & 0x7fffffffu, uvec3((127u + exponent) << 23u)));
}
