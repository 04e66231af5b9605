// Images of different seeds: is a difference between two renderers more than noise?
// Samples of one seed are not independent of each other where they are stratified, so no variance is taken within an
// image: whole images of independent seeds are the replicates.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/image.h"
#include "compare/statistics.h"

namespace vkpt {

/// One comparison of two means: of a tile or of the whole image, in one channel.
struct MeanComparison {
    std::uint32_t x = 0, y = 0;           ///< first pixel
    std::uint32_t width = 0, height = 0;  ///< in pixels
    std::uint32_t channel = 0;
    Moments a, b;
    TestResult test;
};

struct ReplicateResult {
    std::vector<MeanComparison> tiles;  ///< by row, column, channel
    std::vector<MeanComparison> whole;  ///< by channel
    double level = 0;                   ///< at which each is judged: Sidak's for kFamilyLevel over all
    Image meanA, meanB;

    static constexpr std::uint32_t kTile = 8;     ///< pixels a side
    static constexpr double kFamilyLevel = 0.01;  ///< how often equal renderers are told apart
    /// Means that differ by less, relatively, are equal: rounding may shift both.
    static constexpr double kRounding = 1e-5;

    /// The comparison with the least p.
    [[nodiscard]] const MeanComparison& worst() const;
    /// |t| beyond which the worst comparison is rejected.
    [[nodiscard]] double limit() const;
    [[nodiscard]] bool agrees() const { return worst().test.p >= level; }
};

/// An image of one seed.
using RenderSeed = std::function<Image(std::uint32_t seed)>;

/// Renders `count` images a side, of seeds [firstSeed, firstSeed + count) and the `count` after them, and compares
/// means of 8x8 tiles and of the whole image, channel by channel, by Welch's test. `progress(done)` after each pair.
[[nodiscard]] ReplicateResult compareReplicates(const RenderSeed& a, const RenderSeed& b, std::uint32_t firstSeed,
                                                std::uint32_t count,
                                                const std::function<void(std::uint32_t done)>& progress = {});

}  // namespace vkpt
