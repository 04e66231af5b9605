#version 460
// In: origin; direction; v0; v1; v2. Out: t, b0, b1, facing.
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 5u, kOutputWords = 1u;
#include "probes/probe.glsl"
#include "geometry/triangle.glsl"

void main() {
    if (isIdle()) return;
    ShearedRay ray = shearRay(inputFloat(0u).xyz, inputFloat(1u).xyz);
    putFloat(0u, intersectTriangle(ray, inputFloat(2u).xyz, inputFloat(3u).xyz, inputFloat(4u).xyz));
}
