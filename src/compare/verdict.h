// Whether two images agree, by thresholds as OpenImageIO's idiff has them.
#pragma once
#include <cstdint>
#include <limits>

#include "base/error.h"
#include "base/image.h"

namespace vkpt {

/// Of absolute differences. A pixel counts where any channel, alpha included, differs by more than `above`; the images
/// are too different where more than `percent` of all pixels count, or where any channel differs by more than `hard`.
struct Threshold {
    double above = 1e-6, percent = 0, hard = std::numeric_limits<double>::infinity();
};

struct Verdict {
    std::uint64_t pixels = 0, warned = 0, failed = 0;  ///< in all; that differ by more than a threshold
    ExitCode code = ExitCode::Ok;                      ///< Ok, Warning or Disagree
};

/// Values that are finite in one image only fail whatever the thresholds; those that are NaN or infinite alike agree.
/// Channels are paired by pairChannels, which may throw.
[[nodiscard]] Verdict judge(const Image& image, const Image& reference, const Threshold& warn, const Threshold& fail);

}  // namespace vkpt
