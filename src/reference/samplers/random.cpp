// Independent uniform bits from a hash of everything that names the sample.
#include "reference/sampler.h"

namespace vkpt::reference {

std::uint32_t randomBits(SampleId id, std::uint32_t dim) { return hash({id.pixel, id.index, dim, id.seed}).x; }

}  // namespace vkpt::reference
