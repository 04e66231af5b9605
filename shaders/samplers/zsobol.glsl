// Blue-noise error by hierarchical ordering of pixels [Ahmed 20]: one (0,2)-sequence runs along a Z curve over the
// screen, pixel by pixel; at each node of the curve's quadtree the four parts are visited in random order.
#include "samplers/net02.glsl"

// Bit k of x at place 2k.
uint spreadBits(uint x) {
    x = (x | (x << 8u)) & 0x00ff00ffu;
    x = (x | (x << 4u)) & 0x0f0f0f0fu;
    x = (x | (x << 2u)) & 0x33333333u;
    return (x | (x << 1u)) & 0x55555555u;
}

// One of the 24 permutations of {0, 1, 2, 3}. Each is d -> A d + t over the two bits of d: t is one of four, A one of
// six invertible matrices, whose columns kColumns holds, two bits each.
uint permuteFour(uint digit, uint node) {
    const uint kColumns = 0xb7e6d9u;
    uint columns = kColumns >> (4u * multiplyHigh(node, 6u));
    uint first = (digit & 1u) != 0u ? columns & 3u : 0u, second = (digit & 2u) != 0u ? (columns >> 2u) & 3u : 0u;
    return first ^ second ^ (node & 3u);
}

// Hash of the node below which the `taken` upper bits of `bits` lead: nodes are numbered as in a heap.
uint nodeHash(uint morton, uint bits, uint taken, uint key) {
    uint above = taken == 0u ? 0u : morton >> (bits - taken);
    return mixBits(key ^ (above | (1u << taken)));
}

// Every digit of the Z index permuted by its node. No hash waits for another.
uint shuffledIndex(uint morton, uint bits, uint key) {
    uint shuffled = 0u, taken = 0u;
    [[unroll]] for (; taken + 2u <= bits; taken += 2u) {
        uint digit = (morton >> (bits - 2u - taken)) & 3u;
        shuffled = (shuffled << 2u) | permuteFour(digit, nodeHash(morton, bits, taken, key));
    }
    if (taken < bits) shuffled = (shuffled << 1u) | ((morton ^ nodeHash(morton, bits, taken, key)) & 1u);
    return shuffled;
}

uvec2 zsobolPair(SampleId id, uint pair) {
    uint sampleBits = uint(findMSB(id.spp * 2u - 1u)), level = min(kZCurveLevels, (32u - sampleBits) >> 1u);
    uint x = id.pixel & 0xffffu, y = id.pixel >> 16u, mask = (1u << level) - 1u;
    uint morton = spreadBits(x & mask) | (spreadBits(y & mask) << 1u);
    uint index = (morton << sampleBits) | (id.index & ((1u << sampleBits) - 1u));
    // What lies beyond the curve, and beyond its samples, is another curve.
    uvec4 node = samplerKey((x >> level) | ((y >> level) << 16u), pair, id.seed, id.index >> sampleBits);
    uvec4 key = samplerKey(kNone, pair, id.seed, 0u);
    uvec2 point = net02Point(shuffledIndex(index, 2u * level + sampleBits, node.x));
    return uvec2(owenScramble(point.x, key.x), owenScramble(point.y, key.y));
}
