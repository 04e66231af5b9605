// Random numbers of a path, for kernels that draw some.
#include "samplers.glsl"

vec2 toUnit(uvec2 bits) { return vec2(toUnit(bits.x), toUnit(bits.y)); }
vec2 samplePath2D(SampleId id, uint dim) { return toUnit(samplerPair(id, dim >> 1u)); }  // dim is even
uint bounceDimension(uint dim) { return kDimBounce + batch.bounce * kDimBounceStride + dim; }
