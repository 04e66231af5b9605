// FLIP: how strongly the difference of two images shows when one is flipped for the other.
#pragma once
#include <cstdint>

#include "base/image.h"

namespace vkpt {

/// Pixels per degree of vision: a screen 3840 pixels and 0.7 m wide seen from 0.7 m, the method's default.
inline constexpr double kFlipPixelsPerDegree = 67.0206432765823;

/// Of linear images: they are compared at `count` exposures from `start` to `stop`, in EV.
struct FlipExposures {
    double start = 0, stop = 0;
    std::uint32_t count = 1;
};

struct FlipResult {
    double mean = 0;  ///< over all pixels, 0 to 1
    Image map;        ///< one channel: each pixel's
};

/// LDR-FLIP of display-encoded images; values are clamped to [0, 1]. [Andersson 20]
/// Images have three channels, or one that is shown as grey; sizes are equal and all values finite.
[[nodiscard]] FlipResult ldrFlip(const Image& image, const Image& reference);

/// HDR-FLIP of linear images: the largest LDR-FLIP over the exposures, tone mapped by the ACES curve. [Andersson 21]
/// Values are clamped to [0, 65536]; else as ldrFlip.
[[nodiscard]] FlipResult hdrFlip(const Image& image, const Image& reference, const FlipExposures& exposures);

/// The range of exposures for a linear reference: from where its largest luminance is shown at 0.85 to where its median
/// is, in steps of about 1 EV. [Andersson 21] Where the median is black, of which the paper does not speak, that of
/// what is not black is taken; a range ends after 20 EV; a black reference is seen at 0 EV.
[[nodiscard]] FlipExposures flipExposures(const Image& reference);

}  // namespace vkpt
