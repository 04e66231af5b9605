// Independent uniform bits: a hash of everything.
#ifndef VKPT_SAMPLERS_RANDOM
#define VKPT_SAMPLERS_RANDOM
uint randomBits(SampleId id, uint dim) { return hash(uvec4(id.pixel, id.index, dim, id.seed)).x; }
#endif
