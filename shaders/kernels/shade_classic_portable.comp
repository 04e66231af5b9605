#version 460
// For devices without subgroup ballot: a module that names the capability would not load there.
#extension GL_GOOGLE_include_directive : require
#define VKPT_NO_BALLOT
#include "kernels/shade_preamble.glsl"
#include "bsdf_classic.glsl"
#include "bsdf/vertex_bsdf.glsl"
const uint kShadeQueue = kQueueHitClassic;
#include "kernels/shade.glsl"
