#version 460
// In: origin, tMax; direction, alpha key. Out: closest hit: t, slot, b1, b2; its instance, whether any hit is found.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
const uint kInputWords = 2u, kOutputWords = 2u;
#include "probes/scene_probe.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "geometry/triangle.glsl"
#include "geometry/wide_node.glsl"
#include "geometry/traverse.glsl"
#include "material/alpha.glsl"

void main() {
    if (isIdle()) return;
    vec4 origin = inputFloat(0u), direction = inputFloat(1u);
    AlphaKey key = AlphaKey(inputWord(1u).w);
    Hit hit;
    bool found;
    for (uint any = 0u; any < 2u; ++any) {   // one copy of the walk to compile
        Hit met = traverse(origin.xyz, direction.xyz, origin.w, key, any != 0u);
        if (any == 0u) hit = met;
        found = met.slot != kNone;
    }
    putWord(0u, uvec4(floatBitsToUint(hit.t), hit.slot, floatBitsToUint(vec2(hit.b1, hit.b2))));
    putWord(1u, uvec4(hit.instance, found ? 1u : 0u, 0u, 0u));
}
