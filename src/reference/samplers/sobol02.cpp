// Padded (0,2)-sequences [Kollig 02]: a shuffled and Owen-scrambled one for every dimension pair. [Burley 20]
#include "reference/sampler.h"
#include "reference/samplers/net02.h"

namespace vkpt::reference {

std::uint32_t sobol02Bits(SampleId id, std::uint32_t dim) {
    return scrambledNet02(id.index, dim % 2, samplerKey(id.pixel, dim / 2, id.seed));
}

}  // namespace vkpt::reference
