#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/shade_preamble.glsl"
#include "bsdf/group_gltf.glsl"
#include "kernels/shade.glsl"
