#include "compare/metrics.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace vkpt {

ImageDifference compareImages(const Image& image, const Image& reference) {
    if (image.width != reference.width || image.height != reference.height)
        throw Error(ExitCode::SizeMismatch, fmt::format("images of {}x{} and {}x{} cannot be compared", image.width,
                                                        image.height, reference.width, reference.height));
    const std::uint32_t channels = std::min({image.channels, reference.channels, 3U});
    ImageDifference result;
    double squares = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const float *a = image.at(x, y), *b = reference.at(x, y);
            for (std::uint32_t c = 0; c < channels; ++c) {
                const double truth = b[c], error = std::abs(double{a[c]} - truth);
                result.meanAbsolute += error;
                squares += error * error;
                result.relativeMse += error * error / (truth * truth + kRelativeErrorFloor);
                if (error <= result.maximum) continue;  // a NaN falls through: it is the worst of differences
                if (!std::isnan(result.maximum)) {
                    result.maximum = error;
                    result.x = x;
                    result.y = y;
                }
            }
        }
    }
    const double count = std::max(1.0, static_cast<double>(channels) * image.width * image.height);
    result.meanAbsolute /= count;
    result.relativeMse /= count;
    result.rootMeanSquare = std::sqrt(squares / count);
    return result;
}

}  // namespace vkpt
