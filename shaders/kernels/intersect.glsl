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

// The queue of hits on triangle `slot`, by its shade group. Where all hits have one, nothing is read.
uint hitQueue(uint slot) {
    uint group = uint(findLSB(kShadeGroups));
    if (bitCount(kShadeGroups) > 1) group = (sceneWord(scene.triangles + slot * 4u).w >> kTriangleGroupShift) & kTriangleGroupMask;
    return group == kGroupGltf ? kQueueHit : (group == kGroupMicrofacet ? kQueueHitMicrofacet : kQueueHitClassic);
}

// Integrator cost adds the throughput of its camera rays.
void countSearch(uint path) {
    vec3 throughput = loadStateFloat(kStateThroughput, path).xyz;
    storeStateFloat(kStateThroughput, path, vec4(throughput * vec3(searchCost, 0.0), 0.0));
}

// Every invocation calls it: `wanted` with the queue of its path.
void appendTo(uint queue, uint wanted, uint path) {
    uint slot = appendSlot(batch.bounce, queue, wanted == queue);
    if (wanted == queue) counters[queueArray(batch.bounce, queue) + slot] = path;
}

void main() {
    uint i = gl_GlobalInvocationID.x, path = 0u, queue = kNone;
    bool live = i < queueSize(batch.bounce, kQueueRay);
    if (live) {
        path = counters[queueArray(batch.bounce, kQueueRay) + i];
        vec3 origin = loadStateFloat(kStateOrigin, path).xyz;
        vec4 direction = loadStateFloat(kStateDirection, path);
        Hit hit = traverse(origin, direction.xyz, uintBitsToFloat(0x7f800000u), alphaKeyOf(path, kRayPath), false);
        bool met = hit.slot != kNone;
        if (kIntegrator == kIntegratorCost) countSearch(path);
        queue = met ? hitQueue(hit.slot) : kQueueMiss;
        if (met || kHasSurfaceLayers)
            storeState(kStateHit, path, uvec4(floatBitsToUint(hit.t), hit.slot, floatBitsToUint(vec2(hit.b1, hit.b2))));
        if (met && kHasInstances != 0u)
            storeStateFloat(kStateDirection, path, vec4(direction.xyz, uintBitsToFloat(hit.instance)));
    }
    if ((kShadeGroups & (1u << kGroupGltf)) != 0u) appendTo(kQueueHit, queue, path);
    if ((kShadeGroups & (1u << kGroupMicrofacet)) != 0u) appendTo(kQueueHitMicrofacet, queue, path);
    if ((kShadeGroups & (1u << kGroupClassic)) != 0u) appendTo(kQueueHitClassic, queue, path);
    appendTo(kQueueMiss, queue, path);
}
