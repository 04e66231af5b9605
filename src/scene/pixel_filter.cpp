#include "scene/pixel_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

constexpr int kFineSteps = 1 << 16;  // of the sums that stand for integrals
constexpr double kFineStep = 2.0 / kFineSteps;

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

struct Interval {
    double begin, end;  ///< within -1 to 1
};

/// A stretch over which the filter has one sign.
struct Lobe {
    double begin, sign;
    std::vector<double> masses = {0};  ///< integral of the magnitude up to each fine step of the lobe
    std::uint32_t cells = 0;

    /// Where the i-th of `cells` equal parts of its mass lies.
    [[nodiscard]] Interval share(std::uint32_t i) const { return {place(i), place(i + 1)}; }

private:
    [[nodiscard]] double place(std::uint32_t i) const {
        const double target = masses.back() * i / cells;
        const auto above = std::ranges::upper_bound(masses, target);
        const auto step = std::min(above - masses.begin(), static_cast<std::ptrdiff_t>(masses.size()) - 1) - 1;
        const auto at = static_cast<std::size_t>(step);
        const double into = (target - masses[at]) / (masses[at + 1] - masses[at]);
        return begin + kFineStep * (static_cast<double>(step) + into);
    }
};

/// The lobes from left to right; kFilterSteps cells are shared out by their mass.
std::vector<Lobe> lobesOf(std::uint32_t filter) {
    std::vector<Lobe> lobes;
    double whole = 0;
    for (int i = 0; i < kFineSteps; ++i) {
        const double begin = -1 + kFineStep * i, value = filterValue(filter, begin + kFineStep / 2);
        const double sign = value < 0 ? -1 : 1;
        if (lobes.empty() || lobes.back().sign != sign) lobes.push_back({begin, sign});
        lobes.back().masses.push_back(lobes.back().masses.back() + std::abs(value) * kFineStep);
        whole += std::abs(value) * kFineStep;
    }
    std::uint32_t left = kFilterSteps;
    const auto mass = [](const Lobe& lobe) { return lobe.masses.back(); };
    for (Lobe& lobe : lobes) {
        lobe.cells = std::max(1U, static_cast<std::uint32_t>(std::lround(kFilterSteps * mass(lobe) / whole)));
        left -= lobe.cells;  // modulo 2^32, like what the largest lobe takes
    }
    std::ranges::max_element(lobes, {}, mass)->cells += left;
    return lobes;
}

/// The interval that, drawn from evenly, has the mean and the variance of the filter over this one.
Interval flattened(std::uint32_t filter, const Interval& part) {
    constexpr int kPoints = 64;
    double mass = 0, first = 0, second = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double x = std::lerp(part.begin, part.end, (i + 0.5) / kPoints);
        const double value = std::abs(filterValue(filter, x)), offset = x - part.begin;
        mass += value;
        first += value * offset;
        second += value * offset * offset;
    }
    const double mean = first / mass, half = std::sqrt(3 * std::max(0.0, second / mass - mean * mean));
    return {part.begin + mean - half, part.begin + mean + half};
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
    const std::vector<Lobe> lobes = lobesOf(params.pixelFilter);
    double sum = 0;
    for (const Lobe& lobe : lobes) sum += lobe.sign * lobe.masses.back();
    std::vector<FilterCell> cells;
    for (const Lobe& lobe : lobes) {
        const double weight = lobe.sign * lobe.masses.back() / sum * kFilterSteps / lobe.cells;
        for (std::uint32_t i = 0; i < lobe.cells; ++i) {
            const Interval share = flattened(params.pixelFilter, lobe.share(i));
            cells.push_back({static_cast<float>(share.begin * params.filterRadius),
                             static_cast<float>(share.end * params.filterRadius), static_cast<float>(weight), 0});
        }
    }
    return cells;
}

}  // namespace vkpt
