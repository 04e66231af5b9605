// Halton's sequence: dimension d is the radical inverse of the index in the d-th prime. [Halton 60]
#include "samplers/radical_inverse.glsl"

uint haltonBits(SampleId id, uint dim) { return haltonDimension(id, dim); }
