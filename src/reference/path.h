// One path, as estimator.md writes it.
#pragma once
#include "reference/light.h"
#include "reference/sampler.h"
#include "scene/render_options.h"

namespace vkpt::reference {

/// What paths leave behind: exact sums, and counts for statistics.
struct PathTally {
    FilmSums sums{};
    std::uint64_t refused = 0;  ///< contributions that addContribution refused
    std::uint64_t pathRays = 0, shadowRays = 0;
};

/// Everything paths read; made once a render. Holds references to both arguments.
class PathTracer {
public:
    PathTracer(const SceneArrays& scene, const RenderOptions& options);

    /// Traces sample `index` of pixel (x, y), full-frame coordinates, row 0 at the top, and adds it to `tally`.
    void trace(std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally) const;

private:
    friend class Path;
    const SceneArrays& scene_;
    const RenderParams& params_;
    Lights lights_;
    SamplerBits bits_;
};

}  // namespace vkpt::reference
