// Random numbers of a path, for kernels that draw some. Before they include this they define kFirstDimension, the lowest
// dimension that they draw.
#include "samplers.glsl"

vec2 samplePath2D(SampleId id, uint dim) {  // dim is even
    uvec2 bits = samplerPair(id, dim >> 1u);
    return vec2(toUnit(bits.x), toUnit(bits.y));
}
uint bounceDimension(uint dim) { return kDimBounce + batch.bounce * kDimBounceStride + dim; }
