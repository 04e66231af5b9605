#version 460
// In: uv0, uv1; material index. Out: the four maps of the material, in the order of their roles.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 4u;
#include "probes/scene_probe.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"

void main() {
    if (isIdle()) return;
    vec4 uv = inputFloat(0u);
    MaterialMaps maps = sampleMaterialMaps(loadMaterial(inputWord(1u).x), SurfaceUv(uv.xy, uv.zw, vec4(1.0)));
    putFloat(kMapBaseColor, maps.baseColor);
    putFloat(kMapMetallicRoughness, maps.metallicRoughness);
    putFloat(kMapNormal, maps.normal);
    putFloat(kMapEmissive, maps.emissive);
}
