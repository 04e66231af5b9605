// The exact film: a contribution is rounded once to fixed point and added to its path's integer sums. [DESIGN]
#include "math/fixed_point.glsl"

// NaN, Inf, 2^40 or more; below 0 (-0 is 0), unless the pixel filter has lobes there.
bool isRefused(vec3 c) {
    bool negative = any(greaterThan(floatBitsToUint(c), uvec3(0x80000000u)));
    return isBeyond(c, kFilmLimitBits) || (kHasNegativeLobes == 0u && negative);
}

// What a camera ray met, for the counts of FilmSums: a surface is counted under alpha too.
const uint kMetNothing = 0u, kMetBackground = 1u, kMetSurface = 2u;

// The contribution, or nothing where it is refused.
vec3 accepted(vec3 c) {
    if (!isRefused(c)) return c;
    atomicAdd(counters[kRefused], 1u);
    return vec3(0.0);
}

// Adds two contributions to the sums of a path; either may be 0. `first`: nothing was added before, the sums begin here.
// `met`: for camera rays.
void addContributions(uint path, vec3 c, vec3 d, bool first, uint met) {
    c = accepted(c);
    d = accepted(d);
    uvec4 red = uvec4(0u), green = uvec4(0u), blue = uvec4(0u);
    if (!first) {
        red = loadState(kStateRed, path);
        green = loadState(kStateGreen, path);
        blue = loadState(kStateBlue, path);
    }
    red.xyz = addFixed(addFixed(red.xyz, toSignedFixedPoint(c.r)), toSignedFixedPoint(d.r));
    green.xyz = addFixed(addFixed(green.xyz, toSignedFixedPoint(c.g)), toSignedFixedPoint(d.g));
    blue.xyz = addFixed(addFixed(blue.xyz, toSignedFixedPoint(c.b)), toSignedFixedPoint(d.b));
    storeState(kStateRed, path, uvec4(red.xyz, red.w + (met == kMetNothing ? 0u : 1u)));
    storeState(kStateGreen, path, uvec4(green.xyz, green.w + (met == kMetSurface ? 1u : 0u)));
    storeState(kStateBlue, path, uvec4(blue.xyz, 0u));
}
