#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/shade_preamble.glsl"
#include "bsdf_classic.glsl"
#include "bsdf/vertex_bsdf.glsl"
const uint kShadeQueue = kQueueHitClassic;
#include "kernels/shade.glsl"
