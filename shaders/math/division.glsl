// Division of integers by what is used often.

// Upper word of a product: floor(a b / 2^32), a uniform number below b where a is uniform bits.
uint multiplyHigh(uint a, uint b) {
    uint high, low;
    umulExtended(a, b, high, low);
    return high;
}

// Division by a number that is used often: reciprocal = floor((2^32 - 1) / d).
struct Divisor {
    uint d, reciprocal;
};

Divisor makeDivisor(uint d) { return Divisor(d, 0xffffffffu / d); }

// Quotient and remainder. Multiplying by the reciprocal falls short by one at most.
uvec2 divide(uint n, Divisor by) {
    uint quotient = multiplyHigh(n, by.reciprocal), remainder = n - quotient * by.d;
    uint more = remainder >= by.d ? 1u : 0u;
    return uvec2(quotient + more, remainder - more * by.d);
}
