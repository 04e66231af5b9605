#include "compare/ssim.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "compare/filter.h"
#include "compare/tiles.h"

namespace vkpt {
namespace {

constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

std::array<double, kSsimWindow> gaussianWindow() {
    std::array<double, kSsimWindow> weights{};
    double sum = 0;
    for (std::size_t i = 0; i < kSsimWindow; ++i) {
        const double d = static_cast<double>(i) - (kSsimWindow - 1) / 2;
        sum += weights[i] = std::exp(-d * d / (2 * kSigma * kSigma));
    }
    for (double& w : weights) w /= sum;
    return weights;
}

/// The weighted means, in every window of a tile, of what `value` gives for each pixel.
template <class Value>
Grid<double> windowMeans(const Tile& tile, const Value& value) {
    static const std::array<double, kSsimWindow> kWeights = gaussianWindow();
    Grid<double> pixels(tile.width + kSsimWindow - 1, tile.height + kSsimWindow - 1);
    for (std::uint32_t y = 0; y < pixels.height(); ++y)
        for (std::uint32_t x = 0; x < pixels.width(); ++x) pixels.row(y)[x] = value(tile.x + x, tile.y + y);
    constexpr std::size_t margin = kSsimWindow / 2;
    return filterColumns<double>(filterRows<double>(pixels, kWeights, margin), kWeights, margin);
}

double ssimSum(const Image& image, const Image& reference, const Tile& tile) {
    const auto a = [&](std::uint32_t x, std::uint32_t y) -> double { return *image.at(x, y); };
    const auto r = [&](std::uint32_t x, std::uint32_t y) -> double { return *reference.at(x, y); };
    const Grid<double> meanA = windowMeans(tile, a), meanR = windowMeans(tile, r);
    const Grid<double> meanAa = windowMeans(tile, [&](auto x, auto y) { return a(x, y) * a(x, y); });
    const Grid<double> meanRr = windowMeans(tile, [&](auto x, auto y) { return r(x, y) * r(x, y); });
    const Grid<double> meanAr = windowMeans(tile, [&](auto x, auto y) { return a(x, y) * r(x, y); });
    double sum = 0;
    for (std::size_t y = 0; y < tile.height; ++y) {
        for (std::size_t x = 0; x < tile.width; ++x) {
            const double muA = meanA.row(y)[x], muR = meanR.row(y)[x];
            const double varianceA = meanAa.row(y)[x] - muA * muA, varianceR = meanRr.row(y)[x] - muR * muR;
            const double covariance = meanAr.row(y)[x] - muA * muR;
            sum += (2 * muA * muR + kC1) * (2 * covariance + kC2) /
                   ((muA * muA + muR * muR + kC1) * (varianceA + varianceR + kC2));
        }
    }
    return sum;
}

}  // namespace

double ssim(const Image& image, const Image& reference) {
    assert(image.channels == 1 && reference.channels == 1);
    assert(image.width == reference.width && image.height == reference.height);
    if (image.width < kSsimWindow || image.height < kSsimWindow) return std::numeric_limits<double>::quiet_NaN();
    const std::uint32_t columns = image.width - kSsimWindow + 1, rows = image.height - kSsimWindow + 1;
    const double sum = sumOverTiles(columns, rows, [&](const Tile& tile) { return ssimSum(image, reference, tile); });
    return sum / (static_cast<double>(columns) * rows);
}

}  // namespace vkpt
