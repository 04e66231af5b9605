// What every shade kernel includes before the file of its group.
#include "kernels/preamble.glsl"
#include "kernels/draw.glsl"
const uint kAppends = 2u;   // to the queues of shadow rays and of the next segments
#include "kernels/append.glsl"
#include "kernels/light_layers.glsl"
#include "material/texture.glsl"
#include "geometry/surface.glsl"
#include "material/maps.glsl"
#include "geometry/octahedral.glsl"
#include "geometry/shading_point.glsl"
