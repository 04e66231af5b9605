#include "reference/sampler.h"

#include <stdexcept>

namespace vkpt::reference {

SamplerBits samplerBits(SamplerChoice sampler) {
    switch (sampler.id) {
#define VKPT_SAMPLER(Name, stem) \
    case SamplerId::Name:        \
        return {[](SampleId id, std::uint32_t dim, ScrambleId) { return stem##Bits(id, dim); }, sampler.scramble};
#define VKPT_SCRAMBLED_SAMPLER(Name, stem) \
    case SamplerId::Name:                  \
        return {stem##Bits, sampler.scramble};
#include "reference_samplers.inc"
#undef VKPT_SAMPLER
#undef VKPT_SCRAMBLED_SAMPLER
    }
    throw std::logic_error("sampler is not in the registry");
}

}  // namespace vkpt::reference
