// Power spectra of points and of images.
#pragma once
#include <cstdint>
#include <vector>

#include "analysis/point_set.h"
#include "base/image.h"

namespace vkpt {

/// Power at the integer frequencies -extent … extent of both axes, row by row; zero frequency in the middle.
struct Spectrum {
    int extent = 0;
    std::vector<double> power;

    [[nodiscard]] int side() const { return 2 * extent + 1; }
    [[nodiscard]] double at(int fx, int fy) const {
        return power[static_cast<std::size_t>((fy + extent) * side() + fx + extent)];
    }
    /// Mean power in rings of width 1, from frequency 1 to `extent`: [f - 1] is that of |frequency| nearest f.
    [[nodiscard]] std::vector<double> radialMean() const;
    /// Power of frequencies with 0 < |frequency| <= limit, over that of all but zero.
    [[nodiscard]] double share(double limit) const;
};

/// |sum of exp(-2 pi i f x)|^2 / N of points in two dimensions: 1 on average for random points.
[[nodiscard]] Spectrum pointSpectrum(const PointSet& points, int extent);

/// The mean of several, of one extent.
[[nodiscard]] Spectrum meanSpectrum(const std::vector<Spectrum>& spectra);

/// Of one channel of a square image, its mean removed, up to Nyquist (extent = width / 2 - 1): |DFT|^2 / pixels.
[[nodiscard]] Spectrum imageSpectrum(const Image& image, std::uint32_t channel);

}  // namespace vkpt
