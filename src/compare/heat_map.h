// Differences as a picture: false colours, and a scale that says what they mean.
#pragma once
#include <string>

#include "base/image.h"

namespace vkpt {

/// One channel: per pixel the largest |a - r| of the colour channels and alpha; NaN where a value is finite in one
/// image only. Throws Error(SizeMismatch) where the sizes differ.
[[nodiscard]] Image absoluteDifference(const Image& image, const Image& reference);

struct HeatMapOptions {
    std::string title;  ///< what is shown; drawn above the scale
    double top = 0;     ///< value of the brightest colour; 0: chosen, see scaleTop
};

/// `values` (one channel, not negative) in the colours of [Smith 15], black to light yellow, NaN in cyan; below the
/// picture a bar with numbers. Small images are enlarged by a whole factor so that the numbers find room. The result
/// has three display-encoded channels: hand it to encodePng as it is.
[[nodiscard]] Image heatMap(const Image& values, const HeatMapOptions& options);

/// The smallest of 1, 2, 5 times a power of ten that at most one value in 200 exceeds: single fireflies do not decide
/// the scale. 1 where every value is 0.
[[nodiscard]] double scaleTop(const Image& values);

}  // namespace vkpt
