// What every kernel of the path tracer includes, in order of need.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/constants.h"
#include "shared/dimensions.h"
#include "shared/layout.h"
#include "specialization.glsl"
#include "geometry/fetch.glsl"
#include "geometry/load.glsl"
#include "math/hash.glsl"
#include "math/division.glsl"
#include "math/trigonometry.glsl"
#include "math/color.glsl"
#include "math/frame.glsl"
#include "math/warp.glsl"
#include "math/spherical_triangle.glsl"
#include "math/cdf.glsl"
#include "samplers/sample_id.glsl"
#include "kernels/state.glsl"
