// Cumulative tables for choosing one of n by a 24-bit uniform number.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace vkpt {

/// Inclusive cumulative distribution of non-negative weights; the last value is exactly 1.
///
/// toUnit yields multiples of 2^-24 (estimator.md), so every value here is one too: the probability of choosing i
/// by `u < cdf[i]` is then cdf[i] - cdf[i-1] exactly, and that difference is the pmf an estimator must divide by.
/// Every positive weight keeps at least 2^-24; a zero weight gets nothing. All-zero weights count as equal ones.
/// Needs fewer than 2^24 positive weights.
[[nodiscard]] std::vector<float> inclusiveCdf(std::span<const double> weights);

/// cdf[i] - cdf[i-1], exact in float.
[[nodiscard]] inline float cdfStep(std::span<const float> cdf, std::size_t i) {
    return i == 0 ? cdf[0] : cdf[i] - cdf[i - 1];
}

}  // namespace vkpt
