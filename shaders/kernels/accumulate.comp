#version 460
// Stage 5: gathers the exact sums of a pixel's paths into the film. One invocation a pixel: no atomics.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/contribution.glsl"

layout(set = 0, binding = 5, std430) restrict buffer FilmWords { uvec4 filmWords[]; };

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= batch.pixelCount) return;
    uint film = (batch.firstPixel - batch.filmFirst + pixel) * 3u;
    uvec4 sums[3] = uvec4[3](filmWords[film], filmWords[film + 1u], filmWords[film + 2u]);
    for (uint i = 0u, path = pixel * batch.sampleCount; i < batch.sampleCount; ++i, ++path) {
        for (uint c = 0u; c < 3u; ++c) {
            uvec4 sum = loadState(kStateRed + c, path);
            sums[c] = uvec4(addFixed(sums[c].xyz, sum.xyz), sums[c].w + sum.w);
        }
    }
    for (uint c = 0u; c < 3u; ++c) filmWords[film + c] = sums[c];
}
