// Small statistics for the tests of samplers and densities.
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace vkpt::test {

/// Pearson's chi-square of counts against expectations, as a standard normal deviate [Wilson 31]. Cells are pooled
/// until each expects at least 20. Samples of the expected distribution exceed 4 once in 30,000 tests.
inline double chiSquareDeviate(const std::vector<double>& counts, const std::vector<double>& expected) {
    double chi2 = 0, pooledCount = 0, pooledExpected = 0;
    std::size_t cells = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        pooledCount += counts[i];
        pooledExpected += expected[i];
        if (pooledExpected < 20 && i + 1 < counts.size()) continue;
        if (pooledExpected > 0) {
            chi2 += (pooledCount - pooledExpected) * (pooledCount - pooledExpected) / pooledExpected;
            ++cells;
        } else if (pooledCount > 0) {
            return INFINITY;  // a sample where none can be
        }
        pooledCount = pooledExpected = 0;
    }
    const double k = static_cast<double>(cells) - 1;
    const double variance = 2 / (9 * k);
    return (std::cbrt(chi2 / k) - (1 - variance)) / std::sqrt(variance);
}

}  // namespace vkpt::test
