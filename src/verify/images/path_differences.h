// Two renderers that take the same decisions, path by path: how many part, by how much, and whether the mean moves.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "film/film.h"

namespace vkpt {

/// Collected over films of one sample a pixel that both renderers made from the same random numbers.
class PathDifferences {
public:
    static constexpr double kRelative = 1e-3;  ///< a path that is off by more in a channel has parted
    static constexpr double kRounding = 1e-5;  ///< of the mean: what rounding alone may shift it by

    /// One path of both films.
    struct Parted {
        std::uint32_t x = 0, y = 0, index = 0;
        double size = 0;  ///< largest difference of a channel
    };

    void add(const Film& device, const Film& reference);
    /// The same of images of sample `index`, one a pixel.
    void add(const Image& device, const Image& reference, std::uint32_t index);

    [[nodiscard]] std::uint64_t paths() const { return paths_; }
    [[nodiscard]] std::uint64_t parted() const { return parted_; }
    [[nodiscard]] double partedShare() const { return static_cast<double>(parted_) / static_cast<double>(paths_); }
    /// Mean over the parted paths of |device - reference|, relative to the reference's mean over all paths.
    [[nodiscard]] double partedSize() const;
    /// The path that is off by most.
    [[nodiscard]] const std::optional<Parted>& worst() const { return worst_; }

    [[nodiscard]] double mean(int channel) const;            ///< of the reference
    [[nodiscard]] double meanDifference(int channel) const;  ///< device - reference
    [[nodiscard]] double standardError(int channel) const;   ///< of meanDifference
    /// |meanDifference| as a share of what three standard errors and rounding allow.
    [[nodiscard]] double meanShare(int channel) const;

private:
    std::uint64_t paths_ = 0, parted_ = 0;
    double partedSum_ = 0;
    std::array<double, 3> sum_{}, squares_{}, reference_{};
    std::optional<Parted> worst_;
};

}  // namespace vkpt
