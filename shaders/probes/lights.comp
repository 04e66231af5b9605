#version 460
// In: point; two sampler values. Out: wi, pdf; radiance, infinite; target, delta.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 2u, kOutputWords = 3u;
#include "probes/scene_probe.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"
#include "lights/environment.glsl"
#include "lights/punctual.glsl"
#include "lights/sample.glsl"

void main() {
    if (isIdle()) return;
    LightSample s = sampleLight(inputFloat(0u).xyz, inputWord(1u).xy);
    putFloat(0u, vec4(s.wi, s.pdf));
    putFloat(1u, vec4(s.radiance, s.infinite ? 1.0 : 0.0));
    putFloat(2u, vec4(s.target, s.delta ? 1.0 : 0.0));
}
