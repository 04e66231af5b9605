#include "compare/metrics.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/channels.h"

namespace vkpt {
namespace {

/// Sums over the values of one channel in one row, or over several rows.
struct Sums {
    std::uint64_t values = 0;
    double absolute = 0, square = 0, relative = 0, relativeRoot = 0;
    double maximum = 0, referenceMaximum = 0;
    std::uint32_t x = 0, y = 0;
    NonFinite nonFinite;

    void addError(double error, std::uint32_t column, std::uint32_t row) {
        if (error <= maximum) return;
        maximum = error;
        x = column;
        y = row;
    }
    void add(float a, float r, std::uint32_t column, std::uint32_t row) {
        if (!std::isfinite(a) || !std::isfinite(r)) return addNonFinite(a, r, column, row);
        const double truth = r, error = std::abs(a - truth), floored = std::abs(truth) + kRelativeErrorFloor;
        ++values;
        absolute += error;
        square += error * error;
        relative += error * error / (truth * truth + kRelativeErrorFloor);
        relativeRoot += error * error / (floored * floored);
        referenceMaximum = std::max(referenceMaximum, truth);
        addError(error, column, row);
    }
    void addNonFinite(float a, float r, std::uint32_t column, std::uint32_t row) {
        nonFinite.inImage += std::isfinite(a) ? 0 : 1;
        nonFinite.inReference += std::isfinite(r) ? 0 : 1;
        if (a == r || (std::isnan(a) && std::isnan(r))) return;
        ++nonFinite.differing;
        addError(std::numeric_limits<double>::infinity(), column, row);
    }
    void add(const Sums& other) {
        values += other.values;
        absolute += other.absolute;
        square += other.square;
        relative += other.relative;
        relativeRoot += other.relativeRoot;
        referenceMaximum = std::max(referenceMaximum, other.referenceMaximum);
        nonFinite.inImage += other.nonFinite.inImage;
        nonFinite.inReference += other.nonFinite.inReference;
        nonFinite.differing += other.nonFinite.differing;
        addError(other.maximum, other.x, other.y);
    }
};

/// One Sums a channel. Rows are summed in parallel and added in their order: the result is the same every time.
std::vector<Sums> sumChannels(const Image& image, const Image& reference, const std::vector<ChannelPair>& pairs) {
    std::vector<Sums> rows(pairs.size() * image.height);
    oneapi::tbb::parallel_for(std::uint32_t{0}, image.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const float *a = image.at(x, y), *r = reference.at(x, y);
            for (std::size_t c = 0; c < pairs.size(); ++c)
                rows[y * pairs.size() + c].add(a[pairs[c].image], r[pairs[c].reference], x, y);
        }
    });
    std::vector<Sums> channels(pairs.size());
    for (std::size_t i = 0; i < rows.size(); ++i) channels[i % pairs.size()].add(rows[i]);
    return channels;
}

ErrorFigures figuresOf(const Sums& sums, double peak) {
    const auto count = static_cast<double>(sums.values);  // 0/0 = NaN is what no value at all should give
    ErrorFigures figures;
    figures.values = sums.values;
    figures.meanAbsolute = sums.absolute / count;
    figures.meanSquare = sums.square / count;
    figures.rootMeanSquare = std::sqrt(figures.meanSquare);
    figures.relativeMse = sums.relative / count;
    figures.mrse = sums.relativeRoot / count;
    figures.psnr = 10 * std::log10(peak * peak / figures.meanSquare);
    if (figures.meanSquare == 0) figures.psnr = std::numeric_limits<double>::infinity();
    figures.maximum = sums.maximum;
    figures.x = sums.x;
    figures.y = sums.y;
    return figures;
}

}  // namespace

ImageDifference compareImages(const Image& image, const Image& reference, std::optional<double> peak) {
    const std::vector<ChannelPair> pairs = pairChannels(image, reference);
    const std::vector<Sums> channels = sumChannels(image, reference, pairs);
    Sums colors, all;
    for (std::size_t c = 0; c < pairs.size(); ++c) {
        if (pairs[c].isColor) colors.add(channels[c]);
        all.add(channels[c]);
    }
    ImageDifference result;
    result.peak = peak.value_or(reference.displayEncoded ? 1 : colors.referenceMaximum);
    static_cast<ErrorFigures&>(result) = figuresOf(colors, result.peak);
    result.nonFinite = all.nonFinite;
    for (std::size_t c = 0; c < pairs.size(); ++c)
        result.channels.push_back({figuresOf(channels[c], result.peak), pairs[c].name});
    return result;
}

}  // namespace vkpt
