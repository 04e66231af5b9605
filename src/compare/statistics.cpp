#include "compare/statistics.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace vkpt {
namespace {

/// No variance at all: the means decide.
TestResult certain(double difference) {
    return difference == 0 ? TestResult{0, 0, 1}
                           : TestResult{std::copysign(std::numeric_limits<double>::infinity(), difference), 0, 0};
}

}  // namespace

Moments momentsOf(std::span<const double> values) {
    Moments m{values.size(), 0, 0};
    if (values.empty()) return m;
    m.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    if (values.size() < 2) return m;
    for (const double v : values) m.variance += (v - m.mean) * (v - m.mean);
    m.variance /= static_cast<double>(values.size() - 1);
    return m;
}

TestResult zTest(double mean, double expected, double standardError) {
    if (standardError == 0) return certain(mean - expected);
    const double z = (mean - expected) / standardError;
    return {z, 0, std::erfc(std::abs(z) / std::sqrt(2.0))};
}

TestResult welchTest(const Moments& a, const Moments& b) {
    assert(a.count >= 2 && b.count >= 2);
    const auto na = static_cast<double>(a.count), nb = static_cast<double>(b.count);
    const double va = a.variance / na, vb = b.variance / nb;
    if (va + vb == 0) return certain(a.mean - b.mean);
    const double t = (a.mean - b.mean) / std::sqrt(va + vb);
    const double degrees = (va + vb) * (va + vb) / (va * va / (na - 1) + vb * vb / (nb - 1));
    const boost::math::students_t distribution(degrees);
    return {t, degrees, 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)))};
}

double criticalT(double level, double degrees) {
    return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees), level / 2));
}

TestResult chiSquareTest(std::span<const double> observed, std::span<const double> expected, double minimumExpected) {
    assert(observed.size() == expected.size());
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });

    double statistic = 0, pooledObserved = 0, pooledExpected = 0;
    std::size_t cells = 0;
    for (const std::size_t i : order) {
        if (expected[i] == 0 && observed[i] > 0) return certain(observed[i]);
        pooledObserved += observed[i];
        pooledExpected += expected[i];
        if (pooledExpected < minimumExpected) continue;
        statistic += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
        pooledObserved = pooledExpected = 0;
        ++cells;
    }
    if (pooledExpected > 0) {  // too little in all for a single full cell: keep it as one
        statistic += (pooledObserved - pooledExpected) * (pooledObserved - pooledExpected) / pooledExpected;
        ++cells;
    }
    if (cells < 2) return {statistic, 0, 1};
    const double degrees = static_cast<double>(cells - 1);
    const boost::math::chi_squared distribution(degrees);
    return {statistic, degrees, boost::math::cdf(boost::math::complement(distribution, statistic))};
}

double sidakLevel(double familyLevel, std::size_t tests) {
    assert(tests > 0);
    return -std::expm1(std::log1p(-familyLevel) / static_cast<double>(tests));
}

}  // namespace vkpt
