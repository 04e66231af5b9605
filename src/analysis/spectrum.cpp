#include "analysis/spectrum.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace vkpt {
namespace {

using Complex = std::complex<double>;

/// exp(-2 pi i f x) for f = 0 … extent.
std::vector<Complex> waves(double x, int extent) {
    std::vector<Complex> result;
    for (int f = 0; f <= extent; ++f) result.push_back(std::polar(1.0, -2 * std::numbers::pi * f * x));
    return result;
}

double frequency(int fx, int fy) { return std::sqrt(static_cast<double>(fx) * fx + static_cast<double>(fy) * fy); }

/// Fills the lower half plane from the upper: real signals have symmetric spectra.
Spectrum symmetric(int extent, const std::vector<Complex>& upper, double scale) {
    Spectrum spectrum{extent, {}};
    const int side = spectrum.side();
    spectrum.power.resize(static_cast<std::size_t>(side) * side);
    for (int fy = 0; fy <= extent; ++fy)
        for (int fx = -extent; fx <= extent; ++fx) {
            const double p = std::norm(upper[static_cast<std::size_t>(fy * side + fx + extent)]) * scale;
            spectrum.power[static_cast<std::size_t>((extent + fy) * side + extent + fx)] = p;
            spectrum.power[static_cast<std::size_t>((extent - fy) * side + extent - fx)] = p;
        }
    return spectrum;
}

}  // namespace

std::vector<double> Spectrum::radialMean() const {
    std::vector<double> sums(static_cast<std::size_t>(extent)), counts(sums.size());
    for (int fy = -extent; fy <= extent; ++fy)
        for (int fx = -extent; fx <= extent; ++fx) {
            const auto ring = static_cast<std::size_t>(std::lround(frequency(fx, fy)));
            if (ring == 0 || ring > sums.size()) continue;
            sums[ring - 1] += at(fx, fy);
            counts[ring - 1] += 1;
        }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    return sums;
}

double Spectrum::share(double limit) const {
    double below = 0, all = 0;
    for (int fy = -extent; fy <= extent; ++fy)
        for (int fx = -extent; fx <= extent; ++fx) {
            if (fx == 0 && fy == 0) continue;
            all += at(fx, fy);
            if (frequency(fx, fy) <= limit) below += at(fx, fy);
        }
    return all > 0 ? below / all : 0;
}

Spectrum pointSpectrum(const PointSet& points, int extent) {
    const int side = 2 * extent + 1;
    std::vector<Complex> upper(static_cast<std::size_t>(extent + 1) * side);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto wx = waves(points.at(i, 0), extent), wy = waves(points.at(i, 1), extent);
        for (int fy = 0; fy <= extent; ++fy)
            for (int fx = -extent; fx <= extent; ++fx) {
                const Complex& x = wx[static_cast<std::size_t>(std::abs(fx))];
                upper[static_cast<std::size_t>(fy * side + fx + extent)] +=
                    (fx < 0 ? std::conj(x) : x) * wy[static_cast<std::size_t>(fy)];
            }
    }
    return symmetric(extent, upper, 1.0 / static_cast<double>(points.size()));
}

Spectrum meanSpectrum(const std::vector<Spectrum>& spectra) {
    Spectrum mean = spectra.front();
    for (std::size_t s = 1; s < spectra.size(); ++s)
        for (std::size_t i = 0; i < mean.power.size(); ++i) mean.power[i] += spectra[s].power[i];
    for (double& p : mean.power) p /= static_cast<double>(spectra.size());
    return mean;
}

Spectrum imageSpectrum(const Image& image, std::uint32_t channel) {
    const auto n = static_cast<int>(image.width);
    const int extent = n / 2 - 1, side = 2 * extent + 1;
    double mean = 0;
    for (std::size_t i = channel; i < image.pixels.size(); i += image.channels) mean += image.pixels[i];
    mean /= static_cast<double>(image.width) * image.height;
    std::vector<Complex> upper(static_cast<std::size_t>(extent + 1) * side);
    std::vector<std::vector<Complex>> wave;  // of each column or row
    for (int x = 0; x < n; ++x) wave.push_back(waves(static_cast<double>(x) / n, extent));
    for (int y = 0; y < n; ++y) {
        std::vector<Complex> row(static_cast<std::size_t>(side));
        for (int x = 0; x < n; ++x) {
            const double value = image.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))[channel] - mean;
            for (int fx = -extent; fx <= extent; ++fx) {
                const Complex& w = wave[static_cast<std::size_t>(x)][static_cast<std::size_t>(std::abs(fx))];
                row[static_cast<std::size_t>(fx + extent)] += value * (fx < 0 ? std::conj(w) : w);
            }
        }
        for (int fy = 0; fy <= extent; ++fy)
            for (int k = 0; k < side; ++k)
                upper[static_cast<std::size_t>(fy * side + k)] +=
                    row[static_cast<std::size_t>(k)] * wave[static_cast<std::size_t>(y)][static_cast<std::size_t>(fy)];
    }
    return symmetric(extent, upper, 1.0 / (static_cast<double>(n) * n));
}

}  // namespace vkpt
