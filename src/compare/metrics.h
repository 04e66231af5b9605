// How far one image is from another.
#pragma once
#include <cstdint>

#include "base/image.h"

namespace vkpt {

/// Keeps dark pixels from deciding the relative error.
inline constexpr double kRelativeErrorFloor = 0.01;

/// Over all pixels and the first three channels.
struct ImageDifference {
    double meanAbsolute = 0;
    double rootMeanSquare = 0;
    double relativeMse = 0;      ///< mean of (a - b)^2 / (b^2 + kRelativeErrorFloor) [Rousselle 11]
    double maximum = 0;          ///< largest absolute difference
    std::uint32_t x = 0, y = 0;  ///< where the largest difference is
};

/// `reference` is the image taken as true. A value that is not finite makes the results so.
/// Throws Error(SizeMismatch) where the sizes differ.
[[nodiscard]] ImageDifference compareImages(const Image& image, const Image& reference);

}  // namespace vkpt
