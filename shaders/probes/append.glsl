// In: whether to append to queue 1 (else to queue 2; 2: to neither). Out: the slot, or kNone. Every invocation takes
// part, as appendSlots demands. The last of its queues is none.
const uint kInputWords = 1u, kOutputWords = 1u;
#include "probes/probe.glsl"
layout(std430, binding = 2) buffer Counters { uint counters[]; };
const uint kAppends = 3u;
#include "kernels/append.glsl"

void main() {
    uint choice = isIdle() ? 2u : inputWord(0u).x;
    uint slots[kAppends] = appendSlots(uint[](16u, 32u, kNone), bool[](choice == 1u, choice == 0u, true));
    if (isIdle()) return;
    putWord(0u, uvec4(choice == 1u ? slots[0] : (choice == 0u ? slots[1] : kNone), 0u, 0u, 0u));
}
