#version 460
// Stage 4: light samples that arrive are added to their path. One at most for each path and bounce: no atomics.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/light_layers.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "geometry/triangle.glsl"
#include "geometry/wide_node.glsl"
#include "geometry/traverse.glsl"
#include "material/alpha.glsl"
#include "kernels/alpha_key.glsl"

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool live = i < queueSize(batch.bounce, kQueueShadow);
    vec4 origin = vec4(0.0), target = vec4(1.0, 1.0, 1.0, -1.0);   // as in intersect.glsl
    if (live) {
        origin = loadStateFloat(kShadowOrigin, i);
        target = loadStateFloat(kShadowTarget, i);
    }
    uint path = floatBitsToUint(origin.w);
    Hit hit = traverse(origin.xyz, target.xyz, target.w, alphaKeyOf(path, kRayShadow), true);
    if (!live || hit.slot != kNone) return;
    vec4 radiance = loadStateFloat(kShadowRadiance, i);
    contribute(path, radiance.xyz, false, kMetNothing, batch.bounce + 1u, floatBitsToUint(radiance.w));
}
