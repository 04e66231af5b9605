#version 460
// Stage 2b, for the camera rays and only where layers are asked for: gathers what the surfaces they met are into the
// film. One invocation a pixel, which walks over its paths: no atomics, no room in the path state.
#extension GL_GOOGLE_include_directive : require
#include "kernels/preamble.glsl"
#include "kernels/film_layers.glsl"
#include "kernels/camera_depth.glsl"
#include "math/fixed_point.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"

struct SurfaceSums {
    uvec3 albedo[3], normal[3], position[3], uv[3], depth[3];   // of uv two are used, of depth one
};

// A value is refused whole, and counted once.
void addValue(inout uvec3 sums[3], vec3 value) {
    if (isBeyond(value, kLayerLimitBits)) {
        atomicAdd(counters[kRefusedInLayers], 1u);
        return;
    }
    for (uint c = 0u; c < 3u; ++c) sums[c] = addFixed(sums[c], toSignedFixedPoint(value[c]));
}

void addSurface(inout SurfaceSums sums, ShadingPoint p) {
    if (kAlbedoWord != kNone) addValue(sums.albedo, surfaceBaseColor(p.material, p.uv, p.maps.baseColor).rgb);
    if (kNormalWord != kNone) addValue(sums.normal, p.frame.n);
    if (kDepthWord != kNone) addValue(sums.depth, vec3(cameraDepth(p.position), 0.0, 0.0));
    if (kPositionWord != kNone) addValue(sums.position, p.position);
    if (kUvWord != kNone) addValue(sums.uv, vec3(p.uv.uv0, 0.0));
}

// The lowest sample index comes first, in the first pass over the pixel and in this one's loop; w says that it came.
void keepFirstIds(uint base, uint slot, uint instance) {
    if (filmWords[base + kIdsWord].w != 0u) return;
    uvec3 ids = uvec3(kNone);
    if (slot != kNone) {
        TriangleRecord t = loadTriangle(slot);
        ids = uvec3(t.primitive, objectOf(slot, instance), t.flags >> kTriangleMaterialShift);
    }
    filmWords[base + kIdsWord] = uvec4(ids, 1u);
}

void loadSums(uint base, uint word, uint count, inout uvec3 sums[3]) {
    if (word == kNone) return;
    for (uint c = 0u; c < count; ++c) sums[c] = filmWords[base + word + c].xyz;
}

void storeSums(uint base, uint word, uint count, uvec3 sums[3]) {
    if (word == kNone) return;
    for (uint c = 0u; c < count; ++c) filmWords[base + word + c].xyz = sums[c];
}

void main() {
    uint pixel = gl_GlobalInvocationID.x;
    if (pixel >= batch.pixelCount) return;
    uint base = layerBase(pixel);
    SurfaceSums sums;
    loadSums(base, kAlbedoWord, 3u, sums.albedo);
    loadSums(base, kNormalWord, 3u, sums.normal);
    loadSums(base, kPositionWord, 3u, sums.position);
    loadSums(base, kUvWord, 2u, sums.uv);
    loadSums(base, kDepthWord, 1u, sums.depth);
    for (uint i = 0u, path = pixel * batch.sampleCount; i < batch.sampleCount; ++i, ++path) {
        uvec4 hit = loadState(kStateHit, path);
        vec4 direction = loadStateFloat(kStateDirection, path);
        if (kIdsWord != kNone) keepFirstIds(base, hit.y, floatBitsToUint(direction.w));
        if (hit.y == kNone) continue;
        addSurface(sums, makeShadingPoint(hit.y, floatBitsToUint(direction.w), uintBitsToFloat(hit.zw), -direction.xyz));
    }
    storeSums(base, kAlbedoWord, 3u, sums.albedo);
    storeSums(base, kNormalWord, 3u, sums.normal);
    storeSums(base, kPositionWord, 3u, sums.position);
    storeSums(base, kUvWord, 2u, sums.uv);
    storeSums(base, kDepthWord, 1u, sums.depth);
}
