// Every sampler dimension an estimator uses, by name. estimator.md says what each decides.
#ifndef VKPT_SHARED_DIMENSIONS_H
#define VKPT_SHARED_DIMENSIONS_H
#include "constants.h"
#ifdef __cplusplus
namespace vkpt {
#endif

// The lower a dimension of Sobol' or Halton, the better it goes with the others: none is left out, what matters most
// comes first.
VKPT_CONST uint kDimFilter = 0u;  // 2D: position in the pixel
VKPT_CONST uint kDimLens = 2u;    // 2D: position on the lens, where the camera has one: then bounces begin at
VKPT_CONST uint kDimBounceBehindLens = 4u;

// Bounce b (0 at the first surface): kDimBounce + b * kDimBounceStride + one of the following.
VKPT_CONST uint kDimBounce = 2u;
VKPT_CONST uint kDimBounceStride = 6u;
VKPT_CONST uint kDimBsdf = 0u;      // 2D: the direction; of glTF's BSDF the lobe before it
VKPT_CONST uint kDimLight = 2u;     // 2D: which light, and the position on it
VKPT_CONST uint kDimLobe = 4u;      // the lobe, of other BSDFs
VKPT_CONST uint kDimRoulette = 5u;  // Russian roulette; a pair with kDimLobe

#ifdef __cplusplus
}  // namespace vkpt
#endif
#endif
