// Luminance of a finished path and its square, in integers. [estimator.md, Layers]

// A channel's sum cut to kLuminanceFractionBits of fraction. Requires it below 2^kLuminanceLimitBits nits.
uvec2 cutChannel(uvec3 sum) { return uvec2(sum.x >> 24u | sum.y << 8u, sum.y >> 24u | sum.z << 8u); }

// a x weight, as three words. Requires weight < 2^16.
uvec3 timesWeight(uvec2 a, uint weight) {
    uint low, lowCarry, high, highCarry, carry;
    umulExtended(a.x, weight, lowCarry, low);
    umulExtended(a.y, weight, highCarry, high);
    uint middle = uaddCarry(high, lowCarry, carry);
    return uvec3(low, middle, highCarry + carry);
}

// Weighted sum of the channels, rounded: 56 bits, 24 of them fraction.
uvec2 pathLuminance(uvec3 red, uvec3 green, uvec3 blue) {
    uvec3 sum = addFixed(timesWeight(cutChannel(red), kLuminanceRed), timesWeight(cutChannel(green), kLuminanceGreen));
    sum = addFixed(addFixed(sum, timesWeight(cutChannel(blue), kLuminanceBlue)), uvec3(1u << 15u, 0u, 0u));
    return uvec2(sum.x >> 16u | sum.y << 16u, sum.y >> 16u | sum.z << 16u);
}

bool isTooBright(uvec3 red, uvec3 green, uvec3 blue) { return max(red.z, max(green.z, blue.z)) >= 1u << 16u; }

// a + b + carry; carry becomes that of the sum.
uint addWithCarry(uint a, uint b, inout uint carry) {
    uint carry0, carry1;
    uint sum = uaddCarry(a, b, carry0);
    sum = uaddCarry(sum, carry, carry1);
    carry = carry0 + carry1;
    return sum;
}

uvec4 addWide(uvec4 a, uvec4 b) {
    uint carry = 0u;
    uint x = addWithCarry(a.x, b.x, carry), y = addWithCarry(a.y, b.y, carry);
    uint z = addWithCarry(a.z, b.z, carry), w = addWithCarry(a.w, b.w, carry);
    return uvec4(x, y, z, w);
}

// a^2 as four words. Requires a < 2^56.
uvec4 squareOf(uvec2 a) {
    uvec2 low, mixed, high;
    umulExtended(a.x, a.x, low.y, low.x);
    umulExtended(a.x, a.y << 1u, mixed.y, mixed.x);   // the mixed product twice: a.y has 24 bits
    umulExtended(a.y, a.y, high.y, high.x);
    return addWide(uvec4(low, high), uvec4(0u, mixed, 0u));
}
