// Stage 2: the closest hit of every ray in the queue; sorts paths into hits and misses.
#include "kernels/preamble.glsl"
#include "kernels/append.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "geometry/triangle.glsl"
#include "geometry/wide_node.glsl"
#include "geometry/traverse.glsl"
#include "material/alpha.glsl"
#include "kernels/alpha_key.glsl"
void main() {
    uint i = gl_GlobalInvocationID.x, path = 0u;
    bool live = i < queueSize(batch.bounce, kQueueRay), met = false;
    if (live) {
        path = counters[queueArray(batch.bounce, kQueueRay) + i];
        vec3 origin = loadStateFloat(kStateOrigin, path).xyz;
        vec4 direction = loadStateFloat(kStateDirection, path);
        Hit hit = traverse(origin, direction.xyz, uintBitsToFloat(0x7f800000u), alphaKeyOf(path, kRayPath), false);
        met = hit.slot != kNone;
        if (met || kHasSurfaceLayers)
            storeState(kStateHit, path, uvec4(floatBitsToUint(hit.t), hit.slot, floatBitsToUint(vec2(hit.b1, hit.b2))));
        if (met && kHasInstances != 0u)
            storeStateFloat(kStateDirection, path, vec4(direction.xyz, uintBitsToFloat(hit.instance)));
    }
    uint hitSlot = appendSlot(batch.bounce, kQueueHit, live && met);
    uint missSlot = appendSlot(batch.bounce, kQueueMiss, live && !met);
    if (live) counters[met ? queueArray(batch.bounce, kQueueHit) + hitSlot
                             : queueArray(batch.bounce, kQueueMiss) + missSlot] = path;
}
