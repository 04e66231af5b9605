// Statistical tests: is a difference more than chance?
#pragma once
#include <cstddef>
#include <span>

namespace vkpt {

/// Of a sample: n values, their mean and unbiased variance.
struct Moments {
    std::size_t count = 0;
    double mean = 0, variance = 0;
};

[[nodiscard]] Moments momentsOf(std::span<const double> values);

/// Outcome of a test. `p`: how likely chance alone gives a statistic at least this extreme.
struct TestResult {
    double statistic = 0;
    double degrees = 0;  ///< degrees of freedom; 0 where the test has none
    double p = 1;
};

/// Two-sided z-test of a mean against a known value with a known standard error.
[[nodiscard]] TestResult zTest(double mean, double expected, double standardError);

/// Welch's two-sided t-test of equal means, variances unknown and unequal. [Welch 47]
/// Two samples without any variance give p = 1 where the means are equal, else 0.
[[nodiscard]] TestResult welchTest(const Moments& a, const Moments& b);

/// |t| that chance alone exceeds with probability `level`, both sides together.
[[nodiscard]] double criticalT(double level, double degrees);

/// Pearson's chi-square test of counts. Cells that expect fewer than `minimumExpected` are pooled, smallest first,
/// until the pool reaches it. Something seen where nothing is expected gives p = 0.
/// `observed` and `expected` have the same length; their sums should agree.
[[nodiscard]] TestResult chiSquareTest(std::span<const double> observed, std::span<const double> expected,
                                       double minimumExpected = 5);

/// The level at which each of `tests` independent tests is judged, so that all of them together have the level
/// `familyLevel`: 1 - (1 - level)^(1/tests). [Sidak 67]
[[nodiscard]] double sidakLevel(double familyLevel, std::size_t tests);

}  // namespace vkpt
