// Probes that read a scene: frame, scene words and scene texels at bindings 2, 3 and 4.
// src/verify/prober.h binds them.
#define VKPT_FRAME_BINDING 2
#include "probes/probe.glsl"
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
