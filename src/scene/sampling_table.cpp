#include "scene/sampling_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kQuanta = 16777216.0;  // 2^24: the grid of toUnit

}  // namespace

std::vector<float> inclusiveCdf(std::span<const double> weights) {
    double total = 0;
    std::uint64_t positive = 0;
    for (const double w : weights) {
        assert(w >= 0 && std::isfinite(w));
        total += w;
        positive += w > 0 ? 1 : 0;
    }
    std::vector<float> cdf(weights.size());
    if (cdf.empty()) return cdf;
    if (positive == 0) {
        const std::vector<double> equal(weights.size(), 1.0);
        return inclusiveCdf(equal);
    }
    assert(static_cast<double>(positive) < kQuanta);

    // One quantum to each positive weight, the others in proportion: cumulative rounding keeps the sum exact.
    const double shared = kQuanta - static_cast<double>(positive);
    double sum = 0;
    std::uint64_t floors = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i];
        floors += weights[i] > 0 ? 1 : 0;
        const double share = std::min(sum / total, 1.0);
        // The last positive weight takes what rounding of `sum` left over.
        const double quanta = floors == positive ? kQuanta : static_cast<double>(floors) + std::floor(shared * share);
        cdf[i] = static_cast<float>(quanta / kQuanta);
    }
    return cdf;
}

}  // namespace vkpt
