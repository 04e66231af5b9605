#include "reference/sampler.h"

#include <stdexcept>

namespace vkpt::reference {

SamplerBits samplerBits(SamplerId sampler) {
    switch (sampler) {
#define VKPT_SAMPLER(Name, stem) \
    case SamplerId::Name:        \
        return stem##Bits;
#include "reference_samplers.inc"
#undef VKPT_SAMPLER
    }
    throw std::logic_error("sampler is not in the registry");
}

}  // namespace vkpt::reference
