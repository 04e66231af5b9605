#version 460
#extension GL_GOOGLE_include_directive : require
#include "kernels/shade_preamble.glsl"
#include "bsdf_microfacet.glsl"
#include "bsdf/vertex_bsdf.glsl"
const uint kShadeQueue = kQueueHitMicrofacet;
#include "kernels/shade.glsl"
