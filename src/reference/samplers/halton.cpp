// Halton's sequence: dimension d is the radical inverse of the index in the d-th prime. [Halton 60]
#include "reference/samplers/radical_inverse.h"

namespace vkpt::reference {

std::uint32_t haltonBits(SampleId id, std::uint32_t dim, ScrambleId scramble) {
    return haltonDimension(id, dim, scramble);
}

}  // namespace vkpt::reference
