// Stage 2: the closest hit of every ray in the queue; sorts paths into hits and misses.
#include "kernels/preamble.glsl"
const uint kAppends = 4u;   // to the queues of hits and of misses
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

// Every invocation calls it: kNone where it has no path to append.
void appendTo(uint queue, uint path) {
    const uint queues[kAppends] = uint[](kQueueHit, kQueueHitMicrofacet, kQueueHitClassic, kQueueMiss);
    const uint groups[kAppends] = uint[](kGroupGltf, kGroupMicrofacet, kGroupClassic, kNone);
    uint counterOf[kAppends], slot = 0u;
    bool wanted[kAppends];
    [[unroll]] for (uint q = 0u; q < kAppends; ++q) {
        bool used = groups[q] == kNone || (kShadeGroups & (1u << groups[q])) != 0u;
        counterOf[q] = used ? queueCounter(batch.bounce, queues[q]) : kNone;
        wanted[q] = queue == queues[q];
    }
    uint slots[kAppends] = appendSlots(counterOf, wanted);
    [[unroll]] for (uint q = 0u; q < kAppends; ++q) slot = wanted[q] ? slots[q] : slot;
    if (queue != kNone) counters[queueArray(batch.bounce, queue) + slot] = path;
}

void main() {
    uint i = gl_GlobalInvocationID.x, path = 0u, queue = kNone;
    bool live = i < queueSize(batch.bounce, kQueueRay);
    vec3 origin = vec3(0.0);
    vec4 direction = vec4(1.0);
    if (live) {
        path = counters[queueArray(batch.bounce, kQueueRay) + i];
        origin = loadStateFloat(kStateOrigin, path).xyz;
        direction = loadStateFloat(kStateDirection, path);
    }
    // All invocations go along, so that the list is read once for all; those without a path meet nothing.
    float tMax = live ? uintBitsToFloat(0x7f800000u) : -1.0;
    Hit hit = traverse(origin, direction.xyz, tMax, alphaKeyOf(path, kRayPath), false);
    bool met = hit.slot != kNone;
    if (live) queue = met ? hitQueue(hit.slot) : kQueueMiss;
    appendTo(queue, path);
    if (!live) return;
    if (kIntegrator == kIntegratorCost) countSearch(path);
    if (met || kHasSurfaceLayers)
        storeState(kStateHit, path, uvec4(floatBitsToUint(hit.t), hit.slot, floatBitsToUint(vec2(hit.b1, hit.b2))));
    if (met && kHasInstances != 0u)
        storeStateFloat(kStateDirection, path, vec4(direction.xyz, uintBitsToFloat(hit.instance)));
}
