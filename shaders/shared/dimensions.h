// Every sampler dimension an estimator uses, by name. estimator.md says what each decides.
#ifndef VKPT_SHARED_DIMENSIONS_H
#define VKPT_SHARED_DIMENSIONS_H
#include "constants.h"
#ifdef __cplusplus
namespace vkpt {
#endif

// Camera: 0 to 7.
VKPT_CONST uint kDimFilter = 0u;  // 2D: position in the pixel
VKPT_CONST uint kDimLens = 2u;    // 2D: reserved

// Bounce b (0 at the first surface): kDimBounce + b * kDimBounceStride + one of the following.
VKPT_CONST uint kDimBounce = 8u;
VKPT_CONST uint kDimBounceStride = 16u;
VKPT_CONST uint kDimLobe = 0u;      // which lobe of the BSDF
VKPT_CONST uint kDimRoulette = 1u;  // Russian roulette; drawn as a pair with kDimLobe
VKPT_CONST uint kDimBsdf = 2u;      // 2D: direction
VKPT_CONST uint kDimLight = 4u;     // 2D: which light, and the position on it

#ifdef __cplusplus
}  // namespace vkpt
#endif
#endif
