// In: whether to append to queue 1 (else to queue 2; 2: to neither). Out: the slot, or kNone. Every invocation takes
// part, as appendSlot demands.
const uint kInputWords = 1u, kOutputWords = 1u;
#include "probes/probe.glsl"
layout(std430, binding = 2) buffer Counters { uint counters[]; };
uint queueCounter(uint bounce, uint queue) { return bounce * 24u + queue * 4u; }
#include "kernels/append.glsl"

void main() {
    uint choice = isIdle() ? 2u : inputWord(0u).x;
    uint first = appendSlot(1u, 1u, choice == 1u), second = appendSlot(1u, 2u, choice == 0u);
    if (isIdle()) return;
    putWord(0u, uvec4(choice == 1u ? first : (choice == 0u ? second : kNone), 0u, 0u, 0u));
}
