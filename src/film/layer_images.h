// AOVs as images: where the integers of a film's layers become what a file shows.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "film/film.h"

namespace vkpt {

/// One AOV: floats, or whole numbers where `isWhole`.
struct LayerImage {
    AovInfo aov;
    bool isWhole = false;
    Image image;                         ///< one channel for each of aov.channels, unless isWhole
    std::vector<std::uint32_t> numbers;  ///< width x height, if isWhole
};

/// The AOVs of the film's layout, in the order of kAovs. Means are exact quotients, rounded once; ids of pixels that
/// met nothing are kNone; the variance of fewer than two samples is 0.
[[nodiscard]] std::vector<LayerImage> layerImages(const Film& film);

/// Paths that were too bright for the sums behind the variance; 0 without that layer.
[[nodiscard]] std::uint64_t pathsWithoutVariance(const Film& film);

}  // namespace vkpt
