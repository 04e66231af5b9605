// Every sampler dimension an estimator uses, by name. estimator.md says what each decides.
#ifndef VKPT_SHARED_DIMENSIONS_H
#define VKPT_SHARED_DIMENSIONS_H
#include "constants.h"
#ifdef __cplusplus
namespace vkpt {
#endif

// The lower a dimension of Sobol' or Halton, the better it goes with the others: none is left out, what matters most
// comes first. A lens would take 2 and 3, and bounces begin at 4.
VKPT_CONST uint kDimFilter = 0u;  // 2D: position in the pixel

// Bounce b (0 at the first surface): kDimBounce + b * kDimBounceStride + one of the following.
VKPT_CONST uint kDimBounce = 2u;
VKPT_CONST uint kDimBounceStride = 6u;
VKPT_CONST uint kDimBsdf = 0u;      // 2D: which lobe, and the direction
VKPT_CONST uint kDimLight = 2u;     // 2D: which light, and the position on it
VKPT_CONST uint kDimLobe = 4u;      // reserved: choices of a BSDF that its direction must not depend on
VKPT_CONST uint kDimRoulette = 5u;  // Russian roulette; a pair with kDimLobe

#ifdef __cplusplus
}  // namespace vkpt
#endif
#endif
