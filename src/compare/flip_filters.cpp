#include "compare/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vkpt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A term of a contrast sensitivity function of space: a sqrt(pi/b) exp(-pi^2 d^2 / b), d in degrees. [Andersson 20,
/// table 1]
struct Term {
    double a, b;
};
constexpr Term kY{1, 0.0047}, kCx{1, 0.0053}, kCzNarrow{13.5, 0.025}, kCzWide{34.1, 0.04};
constexpr double kFeatureWidth = 0.082;  // degrees; twice the deviation of the detectors' Gaussian

std::vector<double> sample(int radius, auto function) {
    std::vector<double> values;
    for (int i = -radius; i <= radius; ++i) values.push_back(function(static_cast<double>(i)));
    return values;
}

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

/// As floats, without the ends that add nothing to a float's sum.
std::vector<float> scaled(const std::vector<double>& values, double factor) {
    constexpr double negligible = 1e-9;
    std::vector<float> result;
    for (const double v : values)
        if (v * factor > negligible) result.push_back(static_cast<float>(v * factor));
    return result;
}

/// Along one axis; the root of the amplitude, since both axes multiply.
std::vector<double> sensitivity(const Term& term, int radius, double pixelsPerDegree) {
    return sample(radius, [&](double pixels) {
        const double d = pixels / pixelsPerDegree;
        return std::sqrt(term.a * std::sqrt(kPi / term.b)) * std::exp(-kPi * kPi * d * d / term.b);
    });
}

/// Positive and negative weights scaled apart, to sums of 1 and -1.
std::vector<float> balanced(const std::vector<double>& values) {
    double positive = 0, negative = 0;
    for (const double v : values) (v > 0 ? positive : negative) += v;
    std::vector<float> result;
    for (const double v : values) result.push_back(static_cast<float>(v > 0 ? v / positive : -v / negative));
    return result;
}

void makeSensitivities(FlipFilters& filters, double pixelsPerDegree) {
    const double widest = std::max({kY.b, kCx.b, kCzNarrow.b, kCzWide.b});
    const auto radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * kPi * kPi)) * pixelsPerDegree));
    const std::vector<double> y = sensitivity(kY, radius, pixelsPerDegree);
    const std::vector<double> cx = sensitivity(kCx, radius, pixelsPerDegree);
    const std::vector<double> narrow = sensitivity(kCzNarrow, radius, pixelsPerDegree);
    const std::vector<double> wide = sensitivity(kCzWide, radius, pixelsPerDegree);
    filters.y = scaled(y, 1 / sum(y));
    filters.cx = scaled(cx, 1 / sum(cx));
    const double planeSum = sum(narrow) * sum(narrow) + sum(wide) * sum(wide);
    filters.czNarrow = scaled(narrow, 1 / std::sqrt(planeSum));
    filters.czWide = scaled(wide, 1 / std::sqrt(planeSum));
}

void makeDetectors(FlipFilters& filters, double pixelsPerDegree) {
    const double deviation = kFeatureWidth / 2 * pixelsPerDegree;
    const auto radius = static_cast<int>(std::ceil(3 * deviation));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
    const std::vector<double> plain = sample(radius, gauss);
    filters.gauss = scaled(plain, 1 / sum(plain));
    filters.edge = balanced(sample(radius, [&](double x) { return -x * gauss(x); }));
    filters.point =
        balanced(sample(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gauss(x); }));
}

}  // namespace

FlipFilters makeFlipFilters(double pixelsPerDegree) {
    FlipFilters filters;
    makeSensitivities(filters, pixelsPerDegree);
    makeDetectors(filters, pixelsPerDegree);
    for (const auto* filter : {&filters.y, &filters.cx, &filters.czNarrow, &filters.czWide, &filters.gauss})
        filters.radius = std::max(filters.radius, filter->size() / 2);
    return filters;
}

}  // namespace vkpt
