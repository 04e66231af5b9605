#version 460
#extension GL_GOOGLE_include_directive : require
const uint kInputWords = 4u, kOutputWords = 3u;
#include "probes/scene_probe.glsl"
#include "bsdf_classic.glsl"
#include "probes/bsdf.glsl"
