// Studies of point sets: each gives a table, JSON and a picture. What `vkpt samples` shows.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/point_set.h"
#include "base/json.h"
#include "plot/drawing.h"

namespace vkpt {

/// A sampler, or, without a choice, the Poisson disk set.
struct StudiedSampler {
    std::string name;
    std::optional<SamplerChoice> choice;

    /// The number of points made where `count` are asked for.
    [[nodiscard]] std::uint32_t roundedCount(std::uint32_t count) const;
    [[nodiscard]] PointSet points(std::uint32_t count, const std::vector<std::uint32_t>& dimensions,
                                  std::uint32_t seed) const;
};

struct StudyRequest {
    std::vector<StudiedSampler> samplers;
    std::uint32_t count = 64, seed = 0;
    std::vector<std::uint32_t> dimensions{0, 1};
    bool grid = false;  ///< draw strata
};

struct Study {
    Json json;
    std::string table;
    Drawing drawing;
};

[[nodiscard]] Study studyPoints(const StudyRequest& request);
/// Every pair of the dimensions, in a triangle.
[[nodiscard]] Study studyProjections(const StudyRequest& request);
/// Star (two dimensions only), L2-star, centred and wrap-around L2 discrepancy, beside what random points have.
[[nodiscard]] Study studyDiscrepancy(const StudyRequest& request);
/// Of the first two dimensions, mean over kSpectrumSeeds seeds.
[[nodiscard]] Study studySpectrum(const StudyRequest& request);
/// Variance of the estimates of every integrand of integrands.h, from 4 samples to `count`.
[[nodiscard]] Study studyConvergence(const StudyRequest& request);
/// n, its digits, and its radical inverse in `base`, for n from 1 to `count`. Base 2 to 36.
[[nodiscard]] Study studyRadicalInverse(std::uint32_t base, std::uint32_t count);

inline constexpr std::uint32_t kSpectrumSeeds = 16;
inline constexpr std::uint32_t kConvergenceTrials = 128;

}  // namespace vkpt
