#version 460
// Where the kernels keep things: push constants, arrays of the path state, counters and queues. Out, a uint each: the
// fields of batch; kRefused and kRefusedInLayers; the counter and the array of every queue of bounces 0 to 2; pixel and
// sample of 40 slots. And a word of its own into slot batch.bounce of every state array. src/verify/probes/state.cpp
// lists the same.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
layout(set = 0, binding = 5, std430) writeonly buffer Outputs { uint outputs[]; };

uint next = 0u;
void put(uint value) { outputs[next++] = value; }

void main() {
    if (gl_GlobalInvocationID.x != 0u) return;
    put(batch.firstPixel);
    put(batch.pixelCount);
    put(batch.firstSample);
    put(batch.sampleCount);
    put(batch.bounce);
    put(batch.capacity);
    put(batch.pathCount);
    put(batch.filmFirst);
    put(batch.filmLayers);
    put(batch.round);
    put(batch.sampleReciprocal);
    put(batch.widthReciprocal);
    put(kRefused);
    put(kRefusedInLayers);
    for (uint bounce = 0u; bounce < 3u; ++bounce)
        for (uint queue = kQueueRay; queue <= kQueueShadow; ++queue) {
            put(queueCounter(bounce, queue));
            put(queueArray(bounce, queue));
        }
    for (uint slot = 0u; slot < 40u; ++slot) {
        SampleId id = sampleIdOf(slot);
        put(id.pixel);
        put(id.index);
    }
    const uint arrays[] = uint[](kStateOrigin, kStateDirection, kStateThroughput, kStateHit, kStateRed, kStateGreen,
                                 kStateBlue, kShadowOrigin, kShadowTarget, kShadowRadiance);
    for (uint i = 0u; i < arrays.length(); ++i)
        storeState(arrays[i], batch.bounce, uvec4(100u + i, 200u + i, 300u + i, 400u + i));
}
