// The scene buffer, read in 16-byte words through one of two forms: a texel buffer (the fast one on CPU-type
// devices) or a storage buffer. The unused binding holds a dummy.
#ifndef VKPT_FRAME_BINDING   // probes bind their arrays first
#define VKPT_FRAME_BINDING 0
#endif
layout(set = 0, binding = VKPT_FRAME_BINDING, std140) uniform Frame {
    SceneHeader header;
    RenderParams params;
    TriangleRecord list[kListMax];   // where there are no more: see searchList
} frame;
// Read before all else: what is read where every invocation runs, drivers on a CPU read once for all of them.
SceneHeader scene = frame.header;
RenderParams render = frame.params;
layout(set = 0, binding = VKPT_FRAME_BINDING + 1, std430) readonly restrict buffer SceneWords { uvec4 sceneWords[]; };
layout(set = 0, binding = VKPT_FRAME_BINDING + 2, rgba32ui) readonly restrict uniform uimageBuffer sceneTexels;

uvec4 sceneWord(uint index) {
    if (kFetchTexel != 0u) return imageLoad(sceneTexels, int(index));
    return sceneWords[index];
}

vec4 sceneWordFloat(uint index) { return uintBitsToFloat(sceneWord(index)); }

// Number `index` of an array that starts at word `base`, four a word.
uint sceneNumber(uint base, uint index) { return sceneWord(base + (index >> 2u))[index & 3u]; }

// Float `index` of an array that starts at word `base`, four floats a word.
float sceneFloat(uint base, uint index) { return uintBitsToFloat(sceneWord(base + (index >> 2u))[index & 3u]); }
