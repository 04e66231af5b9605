#version 460
// In: slot, instance, b1, b2; wo. Out: position, offset; ng, front; ns, light; base colour; uv0, uv1.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 5u;
#include "probes/scene_probe.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"

void main() {
    if (isIdle()) return;
    uvec4 hit = inputWord(0u);
    ShadingPoint p = makeShadingPoint(hit.x, hit.y, uintBitsToFloat(hit.zw), inputFloat(1u).xyz);
    putFloat(0u, vec4(p.position, p.offset));
    putFloat(1u, vec4(p.ng, p.front ? 1.0 : 0.0));
    putFloat(2u, vec4(p.frame.n, uintBitsToFloat(p.light)));
    putFloat(3u, surfaceBaseColor(p.material, p.uv, p.maps.baseColor));
    putFloat(4u, vec4(p.uv.uv0, p.uv.uv1));
}
