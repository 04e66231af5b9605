// Halton's sequence: dimension d is the radical inverse of the index in the d-th prime. [Halton 60]
#include "samplers/radical_inverse.glsl"

uvec2 haltonPair(SampleId id, uint pair) { return haltonDimensions(id, uvec2(2u * pair, 2u * pair + 1u)); }
