#version 460
// Compaction by subgroup ballot or by shared memory, as kUseBallot says.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_ballot : require
#include "probes/append.glsl"
