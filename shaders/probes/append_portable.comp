#version 460
// Compaction on devices without subgroup ballot.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#define VKPT_NO_BALLOT
#include "probes/append.glsl"
