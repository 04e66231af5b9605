// Independent uniform bits: a hash of everything.
uint randomBits(SampleId id, uint dim) { return hash(uvec4(id.pixel, id.index, dim, id.seed)).x; }
