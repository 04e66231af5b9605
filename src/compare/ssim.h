// Structural similarity.
#pragma once
#include "base/image.h"

namespace vkpt {

inline constexpr std::uint32_t kSsimWindow = 11;  ///< pixels on a side

/// Mean structural similarity of two one-channel images of values in [0, 1], 1 where they are equal. [Wang 04, eqs. 13
/// to 17]: Gaussian window of 11x11, sigma 1.5, K1 = 0.01, K2 = 0.03, dynamic range 1, over the positions where the
/// window fits. NaN where it fits nowhere. The sizes must be equal.
[[nodiscard]] double ssim(const Image& image, const Image& reference);

}  // namespace vkpt
