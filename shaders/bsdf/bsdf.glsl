// What BSDF models take and give. Local frame, normal +z; wo and wi point away from the surface; f excludes the cosine;
// pdf is per solid angle. wo.z > 0 everywhere; wi.z < 0 is transmission.
#include "bsdf/hemisphere.glsl"

struct BsdfSample {
    vec3 wi;
    vec3 weight;      // f |cos| / pdf; 0: the direction is invalid
    float pdf;        // negative: a delta lobe
};
