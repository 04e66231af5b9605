#include "scene/pixel_filter.h"

#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

constexpr int kFineSteps = 1 << 16;  // of the sums that stand for integrals

double gaussian(double x) {
    constexpr double kSigma = 1.0 / 3;
    const auto bell = [](double t) { return std::exp(-t * t / (2 * kSigma * kSigma)); };
    return bell(x) - bell(1);
}

double blackmanHarris(double x) {
    const double turn = std::numbers::pi * (x + 1);
    return 0.35875 - 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) - 0.01168 * std::cos(3 * turn);
}

/// B = C = 1/3. [Mitchell 88, eq. 8]
double mitchell(double x) {
    const double t = 2 * std::abs(x);
    if (t < 1) return (7 * t * t * t - 12 * t * t + 16.0 / 3) / 6;
    return (-7.0 / 3 * t * t * t + 12 * t * t - 20 * t + 32.0 / 3) / 6;
}

}  // namespace

double filterValue(std::uint32_t filter, double x) {
    if (std::abs(x) > 1) return 0;
    switch (filter) {
        case kFilterTent:
            return 1 - std::abs(x);
        case kFilterGaussian:
            return gaussian(x);
        case kFilterBlackmanHarris:
            return blackmanHarris(x);
        case kFilterMitchell:
            return mitchell(x);
        default:
            return 1;
    }
}

std::vector<FilterCell> filterTable(const RenderParams& params) {
    if (params.pixelFilter == kFilterBox && params.filterRadius == 0.5F) return {};
    std::vector<double> sums(kFineSteps + 1);  // of the magnitude, up to each step
    const auto place = [](double step) { return 2 * step / kFineSteps - 1; };
    for (int i = 0; i < kFineSteps; ++i)
        sums[static_cast<std::size_t>(i) + 1] =
            sums[static_cast<std::size_t>(i)] + std::abs(filterValue(params.pixelFilter, place(i + 0.5)));
    std::vector<FilterCell> cells(kFilterSteps);
    std::size_t step = 0;
    double begin = -1, signs = 0;
    for (std::uint32_t i = 0; i < kFilterSteps; ++i) {
        const double target = sums.back() * (i + 1) / kFilterSteps;
        while (step + 1 < kFineSteps && sums[step + 1] < target) ++step;
        const double into = (target - sums[step]) / (sums[step + 1] - sums[step]);
        const double end = i + 1 == kFilterSteps ? 1 : place(static_cast<double>(step) + into);
        cells[i] = {static_cast<float>(begin * params.filterRadius), static_cast<float>(end * params.filterRadius),
                    filterValue(params.pixelFilter, (begin + end) / 2) < 0 ? -1.0F : 1.0F, 0};
        signs += cells[i].weight;
        begin = end;
    }
    for (FilterCell& cell : cells) cell.weight *= static_cast<float>(kFilterSteps / signs);
    return cells;
}

}  // namespace vkpt
