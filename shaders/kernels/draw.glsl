// Random numbers of a path, for kernels that draw some.
#include "samplers.glsl"

vec2 toUnit(uvec2 bits) { return vec2(toUnit(bits.x), toUnit(bits.y)); }
vec2 samplePath2D(SampleId id, uint dim) { return toUnit(samplerPair(id, dim >> 1u)); }  // dim is even
// Which bounce the random numbers of this one are of: rounds of integrator direct are all of the first surface.
uint drawnBounce() { return kIntegrator == kIntegratorDirect ? batch.bounce + batch.round : batch.bounce; }
uint bounceDimension(uint dim) {
    return (kHasLens != 0u ? kDimBounceBehindLens : kDimBounce) + drawnBounce() * kDimBounceStride + dim;
}
