#version 460
// In: a value; the sums of a path, three words; two wide sums. Out: toSignedFixedPoint of the value's components, w of the
// first: isBeyond; pathLuminance, isTooBright; squareOf the luminance; addWide of the two.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 6u, kOutputWords = 6u;
#include "probes/probe.glsl"
#include "math/fixed_point.glsl"
#include "kernels/path_luminance.glsl"

void main() {
    if (isIdle()) return;
    vec3 value = inputFloat(0u).xyz;
    uvec3 red = inputWord(1u).xyz, green = inputWord(2u).xyz, blue = inputWord(3u).xyz;
    for (uint i = 0u; i < 3u; ++i)
        putWord(i, uvec4(toSignedFixedPoint(value[i]), isBeyond(value, kLayerLimitBits) ? 1u : 0u));
    uvec2 luminance = pathLuminance(red, green, blue);
    putWord(3u, uvec4(luminance, isTooBright(red, green, blue) ? 1u : 0u, 0u));
    putWord(4u, squareOf(luminance));
    putWord(5u, addWide(inputWord(4u), inputWord(5u)));
}
