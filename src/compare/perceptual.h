// What a viewer sees of a difference: SSIM and FLIP of any two images, the whole and each colour.
#pragma once
#include <string_view>
#include <vector>

#include "base/image.h"
#include "compare/flip.h"

namespace vkpt {

struct PerceptualFigures {
    std::string_view name;  ///< "R", "G" or "B"
    double ssim = 0;
    double flip = 0;  ///< NaN unless it was asked for
};

struct PerceptualOptions {
    bool flipPerChannel = false;  ///< FLIP of each channel shown as grey; more than doubles the time
};

struct PerceptualDifference {
    /// SSIM of the luma (Rec. 709 weights on sRGB-encoded values; linear images are encoded, clipped to [0, 1], first).
    /// NaN for images smaller than its window.
    double ssim = 0;
    FlipResult flip;              ///< LDR-FLIP, or HDR-FLIP of linear images
    FlipExposures flipExposures;  ///< of linear images
    /// Of each colour channel shown as grey; empty for grey images.
    std::vector<PerceptualFigures> channels;
};

/// `reference` is the image taken as true. Pixels with a value that is not finite, in either image, are black in both.
/// Channels are paired by pairChannels, which may throw; alpha is not looked at.
[[nodiscard]] PerceptualDifference comparePerceptually(const Image& image, const Image& reference,
                                                       const PerceptualOptions& options = {});

}  // namespace vkpt
