#include "compare/verdict.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare/channels.h"

namespace vkpt {
namespace {

struct Counts {
    std::uint64_t warned = 0, failed = 0;
    double largest = 0;  ///< infinite where a value is finite in one image only
};

/// The largest difference of a pixel.
double pixelDifference(const float* a, const float* r, const std::vector<ChannelPair>& pairs) {
    double largest = 0;
    for (const ChannelPair& pair : pairs) {
        const double va = a[pair.image], vr = r[pair.reference];
        if (va == vr || (std::isnan(va) && std::isnan(vr))) continue;
        const double difference = std::abs(va - vr);
        largest = std::max(largest, std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference);
    }
    return largest;
}

Counts count(const Image& image, const Image& reference, double warnAbove, double failAbove) {
    const std::vector<ChannelPair> pairs = pairChannels(image, reference);
    const auto countRows = [&](const auto& rows, Counts counts) {
        for (std::uint32_t y = rows.begin(); y < rows.end(); ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const double difference = pixelDifference(image.at(x, y), reference.at(x, y), pairs);
                counts.warned += difference > warnAbove ? 1 : 0;
                counts.failed += difference > failAbove ? 1 : 0;
                counts.largest = std::max(counts.largest, difference);
            }
        }
        return counts;
    };
    const auto add = [](const Counts& a, const Counts& b) {
        return Counts{a.warned + b.warned, a.failed + b.failed, std::max(a.largest, b.largest)};
    };
    return oneapi::tbb::parallel_reduce(oneapi::tbb::blocked_range<std::uint32_t>(0, image.height), Counts{}, countRows,
                                        add);
}

bool exceeds(const Threshold& threshold, std::uint64_t counted, std::uint64_t pixels, double largest) {
    return static_cast<double>(counted) > threshold.percent / 100 * static_cast<double>(pixels) ||
           largest > threshold.hard;
}

}  // namespace

Verdict judge(const Image& image, const Image& reference, const Threshold& warn, const Threshold& fail) {
    const Counts counts = count(image, reference, warn.above, fail.above);
    Verdict verdict{std::uint64_t{image.width} * image.height, counts.warned, counts.failed};
    if (std::isinf(counts.largest) || exceeds(fail, counts.failed, verdict.pixels, counts.largest))
        verdict.code = ExitCode::Disagree;
    else if (exceeds(warn, counts.warned, verdict.pixels, counts.largest))
        verdict.code = ExitCode::Warning;
    return verdict;
}

}  // namespace vkpt
