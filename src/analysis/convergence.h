// How the variance of an estimate falls with the number of samples.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/integrands.h"
#include "scene/sampler_choice.h"

namespace vkpt {

struct Estimates {
    std::uint32_t count = 0;   ///< samples of each
    double meanError = 0;      ///< of the estimates against the integral
    double variance = 0;       ///< mean squared error against the integral
    double standardError = 0;  ///< of meanError
};

/// `trials` estimates, each from `count` samples of another pixel and seed, in dimensions 0, 1, ….
[[nodiscard]] Estimates estimate(SamplerChoice sampler, const Integrand& integrand, std::uint32_t count,
                                 std::uint32_t trials, std::uint32_t seed);

struct Convergence {
    std::vector<Estimates> estimates;
    double slope = 0;  ///< of log variance over log count, least squares; 0 where a variance is 0
};

/// At each count, rounded as the sampler wants it. Runs on all threads.
[[nodiscard]] Convergence convergence(SamplerChoice sampler, const Integrand& integrand,
                                      const std::vector<std::uint32_t>& counts, std::uint32_t trials,
                                      std::uint32_t seed);

}  // namespace vkpt
