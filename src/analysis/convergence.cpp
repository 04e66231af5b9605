#include "analysis/convergence.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "analysis/point_set.h"

namespace vkpt {
namespace {

double fittedSlope(const std::vector<Estimates>& estimates) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Estimates& e : estimates) {
        if (e.variance <= 0) return 0;
        const double a = std::log(static_cast<double>(e.count)), b = std::log(e.variance);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    const double spread = n * xx - x * x;
    return spread > 0 ? (n * xy - x * y) / spread : 0;
}

}  // namespace

Estimates estimate(SamplerChoice sampler, const Integrand& integrand, std::uint32_t count, std::uint32_t trials,
                   std::uint32_t seed) {
    std::vector<std::uint32_t> dimensions;
    for (std::uint32_t d = 0; d < integrand.dims; ++d) dimensions.push_back(d);
    std::vector<double> errors(trials);
    tbb::parallel_for(0U, trials, [&](std::uint32_t trial) {
        const std::uint32_t pixel = (trial * 37 & 0xffU) | (trial * 101 & 0xffU) << 16U;
        const PointSet points = samplePoints(sampler, count, dimensions, seed + trial, pixel);
        double sum = 0;
        for (std::size_t i = 0; i < points.size(); ++i) sum += integrand.value(points.point(i));
        errors[trial] = sum / count - integrand.integral;
    });
    Estimates result{count, 0, 0, 0};
    for (const double error : errors) {
        result.meanError += error / trials;
        result.variance += error * error / trials;
    }
    const double spread = result.variance - result.meanError * result.meanError;
    result.standardError = std::sqrt(std::max(spread, 0.0) / trials);
    return result;
}

Convergence convergence(SamplerChoice sampler, const Integrand& integrand, const std::vector<std::uint32_t>& counts,
                        std::uint32_t trials, std::uint32_t seed) {
    Convergence result;
    for (const std::uint32_t wanted : counts) {
        const std::uint32_t count = sampleCount(sampler.id, wanted);
        if (!result.estimates.empty() && result.estimates.back().count == count) continue;
        result.estimates.push_back(estimate(sampler, integrand, count, trials, seed));
    }
    result.slope = fittedSlope(result.estimates);
    return result;
}

}  // namespace vkpt
