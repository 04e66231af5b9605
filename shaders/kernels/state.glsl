// Path state, queues and counters: structures of arrays in 16-byte words. A path keeps its slot for life; queues
// hold slots. Changed an array or a counter? Update src/wavefront/layout.h.
layout(local_size_x = 64) in;

struct Batch {
    uint firstPixel, pixelCount;     // pixels of the frame, row by row
    uint firstSample, sampleCount;
    uint bounce;
    uint capacity;                   // slots of every array
    uint pathCount;                  // pixelCount * sampleCount
    uint filmFirst;                  // first pixel of the band of the film that is bound
    uint filmLayers;                 // word of the film where the layers of its pixels begin
    uint round;                      // of integrator direct, else 0: its paths begin anew, their sums go on
    uint sampleReciprocal, widthReciprocal;   // of Divisor: of sampleCount, of the frame's width
};
layout(push_constant) uniform BatchBlock { Batch pushed; };
Batch batch = pushed;   // as in geometry/fetch.glsl

layout(set = 0, binding = 3, std430) buffer StateWords { uvec4 stateWords[]; };
layout(set = 0, binding = 4, std430) restrict buffer Counters { uint counters[]; };
// The words of stateWords as texels, for reading: faster where kStateTexel says so. A kernel reads no word after it
// has written it.
layout(set = 0, binding = 6, rgba32ui) readonly uniform uimageBuffer stateTexels;

// Arrays of stateWords, each `capacity` long.
const uint kStateOrigin = 0u;      // xyz origin; w pdf of the BSDF sample, negative: MIS weight 1
const uint kStateDirection = 1u;   // xyz direction; w instance of the hit
const uint kStateThroughput = 2u;  // xyz; w medium that the path is in, 0: none
const uint kStateHit = 3u;         // t, slot, b1, b2
const uint kStateRed = 4u, kStateGreen = 5u, kStateBlue = 6u;  // exact sums; red.w: alpha
const uint kShadowOrigin = 7u;     // xyz; w: path slot
const uint kShadowTarget = 8u;     // xyz: from the origin to the light; w: tMax
const uint kShadowRadiance = 9u;   // xyz; w: group of the light

uvec4 loadState(uint array, uint slot) {
    uint word = array * batch.capacity + slot;
    if (kStateTexel != 0u) return imageLoad(stateTexels, int(word));
    return stateWords[word];
}
void storeState(uint array, uint slot, uvec4 value) { stateWords[array * batch.capacity + slot] = value; }
vec4 loadStateFloat(uint array, uint slot) { return uintBitsToFloat(loadState(array, slot)); }
void storeStateFloat(uint array, uint slot, vec4 value) { storeState(array, slot, floatBitsToUint(value)); }

// Counters: what was refused, then a block a bounce, then the queues. A queue's part of a block begins with
// {groups, 1, 1, items}, of which the first three are the arguments of its indirect dispatch, and fills a line of a
// cache: one core then reads how long a queue is while another appends to the next.
// Hits have a queue a shade group; that of kGroupGltf is kQueueHit.
const uint kQueueRay = 0u, kQueueHit = 1u, kQueueMiss = 2u, kQueueHitMicrofacet = 3u, kQueueHitClassic = 4u;
const uint kQueueShadow = 5u;
const uint kRefused = 0u, kRefusedInLayers = 1u;
const uint kQueueCounter = 16u;
const uint kCounterBlock = 6u * kQueueCounter;
const uint kMaxBounceBlocks = 4096u;
const uint kQueueBase = kQueueCounter + kCounterBlock * kMaxBounceBlocks;

uint queueCounter(uint bounce, uint queue) { return kQueueCounter + bounce * kCounterBlock + queue * kQueueCounter; }
uint queueSize(uint bounce, uint queue) { return counters[queueCounter(bounce, queue) + 3u]; }
// Ray queues alternate between two arrays by the parity of the bounce; hits and misses follow.
uint queueArray(uint bounce, uint queue) {
    return kQueueBase + (queue == kQueueRay ? bounce & 1u : queue + 1u) * batch.capacity;
}

// The samples of a pixel are neighbours: they take the same way through tree and textures.
SampleId sampleIdOf(uint path) {
    uvec2 place = divide(path, Divisor(batch.sampleCount, batch.sampleReciprocal));
    uvec2 row = divide(batch.firstPixel + place.x, Divisor(render.width, batch.widthReciprocal));
    uint spp = kSetSamples != 0u ? kSetSamples : render.spp;
    return SampleId(row.y | row.x << 16u, batch.firstSample + place.y, spp, render.seed);
}
