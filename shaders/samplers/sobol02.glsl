// Padded (0,2)-sequences [Kollig 02]: every dimension pair is the first two of Sobol', its order shuffled and both
// coordinates Owen-scrambled. [Burley 20]
#include "samplers/net02.glsl"

uvec2 sobol02Pair(SampleId id, uint pair) {
    return scrambledNet02(id.index, samplerKey(id.pixel, pair, id.seed, 0u));
}
