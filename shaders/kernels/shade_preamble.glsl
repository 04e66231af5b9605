// What every shade kernel includes before the file of its group.
#include "kernels/preamble.glsl"
const uint kFirstDimension = kDimBounce;
#include "kernels/draw.glsl"
#include "kernels/append.glsl"
#include "kernels/contribution.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"
