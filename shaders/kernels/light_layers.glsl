// The film's layers of light: what is added to a path is added, as the same integers, to the layer of its length and to
// that of its light's group. Paths of one pixel add at the same time, hence atomics; sums do not depend on their order.
// [estimator.md, Layers of light]
#include "kernels/contribution.glsl"
#include "kernels/film_layers.glsl"

// filmWords[word] += b modulo 2^96. Each word hands on its carries; these add up in any order too.
void addAtomically(uint word, uvec3 b) {
    if (b == uvec3(0u)) return;
    uint before = atomicAdd(filmWords[word].x, b.x);
    uint carry = before > ~b.x ? 1u : 0u;
    uint middle = b.y + carry, wrapped = middle < carry ? 1u : 0u;   // then middle is 0 and carries nothing more
    before = atomicAdd(filmWords[word].y, middle);
    uint high = b.z + wrapped + (before > ~middle ? 1u : 0u);
    if (high != 0u) atomicAdd(filmWords[word].z, high);
}

// The layer that begins at `word` of its pixel.
void addToLayer(uint path, uint word, vec3 c) {
    uint base = layerBase(path / batch.sampleCount) + word;
    for (uint i = 0u; i < 3u; ++i) addAtomically(base + i, toSignedFixedPoint(c[i]));
}

// A contribution to the layers. `scatterings`: on its way to the camera; `group`: of its light.
void addToLayers(uint path, vec3 c, uint scatterings, uint group) {
    if ((kLengthWord == kNone && kGroupWord == kNone) || isRefused(c)) return;
    if (kLengthWord != kNone) addToLayer(path, kLengthWord + 3u * min(scatterings, kLengthLayers - 1u), c);
    if (kGroupWord != kNone) addToLayer(path, kGroupWord + 3u * group, c);
}

// A contribution to the path and to the layers.
void contribute(uint path, vec3 c, bool first, uint met, uint scatterings, uint group) {
    addContributions(path, c, vec3(0.0), first, met);
    addToLayers(path, c, scatterings, group);
}

// The group of what a triangle emits.
uint emitterGroup(uint triangle, uint instance) {
    return kGroupWord == kNone ? 0u : sceneNumber(scene.objectGroups, objectOf(triangle, instance));
}
