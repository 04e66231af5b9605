// Two renderers that take the same decisions, path by path: how many part, by how much, and whether the mean moves.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "film/film.h"
#include "scene/render_options.h"

namespace vkpt {

/// Collected over films of one sample a pixel that both renderers made from the same random numbers.
class PathDifferences {
public:
    static constexpr double kRelative = 1e-3;  ///< a path that is off by more in a channel has parted
    static constexpr double kRounding = 1e-5;  ///< of the mean: what rounding alone may shift it by

    /// Share of paths that may part without an excuse: it grows from bounce to bounce.
    [[nodiscard]] static double mostParted(const RenderParams& params);
    static constexpr double kMostExcused = 0.1;  ///< share of paths that rounding may decide, if the rest is to tell

    /// One path of both films.
    struct Parted {
        std::uint32_t x = 0, y = 0, index = 0;
        double size = 0;  ///< largest difference of a channel
        bool excused = false;
    };

    /// `twins`: the reference with what rounding may change in its input changed. Where one of them parts from
    /// `reference`, rounding decides, and a device that parts is excused.
    void add(const Film& device, const Film& reference, std::span<const Film> twins = {});
    /// The same of images of sample `index`, one a pixel.
    void add(const Image& device, const Image& reference, std::uint32_t index, std::span<const Image> twins = {});

    [[nodiscard]] std::uint64_t paths() const { return paths_; }
    [[nodiscard]] std::uint64_t parted() const { return parted_; }
    [[nodiscard]] std::uint64_t excused() const { return excused_; }  ///< of the parted
    [[nodiscard]] double partedShare() const { return static_cast<double>(parted_) / static_cast<double>(paths_); }
    /// Mean over the parted paths of |device - reference|, relative to the reference's mean over all paths.
    [[nodiscard]] double partedSize() const;
    [[nodiscard]] double excusedShare() const { return static_cast<double>(excused_) / static_cast<double>(paths_); }
    /// The path that is off by most, one that is not excused if there is any.
    [[nodiscard]] const std::optional<Parted>& worst() const { return worst_; }

    [[nodiscard]] double mean(int channel) const;            ///< of the reference
    [[nodiscard]] double meanDifference(int channel) const;  ///< device - reference
    [[nodiscard]] double standardError(int channel) const;   ///< of meanDifference
    /// |meanDifference| as a share of what three standard errors and rounding allow.
    [[nodiscard]] double meanShare(int channel) const;

private:
    std::uint64_t paths_ = 0, parted_ = 0, excused_ = 0;
    double partedSum_ = 0;
    std::array<double, 3> sum_{}, squares_{}, reference_{};
    std::optional<Parted> worst_;
};

}  // namespace vkpt
