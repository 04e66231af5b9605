#version 460
// Stage 5: gathers the exact sums of a pixel's paths into the film. One invocation a pixel: no atomics.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/film_layers.glsl"
#include "math/fixed_point.glsl"
#include "kernels/path_luminance.glsl"

// Sums of the luminance layer: of luminances, w the paths left out; of their squares.
struct LuminanceSums {
    uvec4 first, squares;
};

void addLuminance(inout LuminanceSums sums, uvec3 red, uvec3 green, uvec3 blue) {
    bool tooBright = isTooBright(red, green, blue);
    uvec2 luminance = tooBright ? uvec2(0u) : pathLuminance(red, green, blue);
    sums.first = uvec4(addFixed(sums.first.xyz, uvec3(luminance, 0u)), sums.first.w + (tooBright ? 1u : 0u));
    sums.squares = addWide(sums.squares, squareOf(luminance));
}

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= batch.pixelCount) return;
    uint film = (batch.firstPixel - batch.filmFirst + pixel) * 3u, layer = layerBase(pixel) + kLuminanceWord;
    uvec4 sums[3] = uvec4[3](filmWords[film], filmWords[film + 1u], filmWords[film + 2u]);
    LuminanceSums luminance;
    if (kLuminanceWord != kNone) luminance = LuminanceSums(filmWords[layer], filmWords[layer + 1u]);
    for (uint i = 0u, path = pixel * batch.sampleCount; i < batch.sampleCount; ++i, ++path) {
        uvec4 own[3];
        for (uint c = 0u; c < 3u; ++c) {
            own[c] = loadState(kStateRed + c, path);
            sums[c] = uvec4(addFixed(sums[c].xyz, own[c].xyz), sums[c].w + own[c].w);
        }
        if (kLuminanceWord != kNone) addLuminance(luminance, own[0].xyz, own[1].xyz, own[2].xyz);
    }
    for (uint c = 0u; c < 3u; ++c) filmWords[film + c] = sums[c];
    if (kLuminanceWord != kNone) {
        filmWords[layer] = luminance.first;
        filmWords[layer + 1u] = luminance.squares;
    }
}
