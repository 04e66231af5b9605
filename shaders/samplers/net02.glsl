// The (0,2)-sequence in base 2 behind sobol02, zsobol and bluenoise.
#ifndef VKPT_SAMPLERS_NET02
#define VKPT_SAMPLERS_NET02
#include "samplers/bits.glsl"

// A point of the (0,2)-sequence of [Sobol 67]: the van der Corput sequence, and the one whose matrix is Pascal's
// triangle modulo 2, a fivefold Kronecker power of (1 1; 0 1).
uvec2 net02Point(uint index) {
    uint second = index;
    second ^= (second >> 1u) & 0x55555555u;
    second ^= (second >> 2u) & 0x33333333u;
    second ^= (second >> 4u) & 0x0f0f0f0fu;
    second ^= (second >> 8u) & 0x00ff00ffu;
    second ^= second >> 16u;
    return uvec2(bitfieldReverse(index), bitfieldReverse(second));
}

// Sample `index` of the sequence shuffled by key.x and scrambled by key.y and key.z.
uvec2 scrambledNet02(uint index, uvec4 key) {
    uvec2 point = net02Point(owenScramble(index, key.x));
    return uvec2(owenScramble(point.x, key.y), owenScramble(point.y, key.z));
}
#endif
