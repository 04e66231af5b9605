// One path, as estimator.md writes it: as a whole, and step by step for those who look at single ones.
#pragma once
#include <vector>

#include "reference/surface.h"
#include "reference/traverse.h"
#include "scene/render_options.h"

namespace vkpt::reference {

class LayerTally;
struct LightOrigin;

/// What paths leave behind: exact sums, and counts for statistics.
struct PathTally {
    FilmSums sums{};
    std::uint64_t refused = 0;  ///< contributions that addContribution refused
    std::uint64_t pathRays = 0, shadowRays = 0;
    LayerTally* layers = nullptr;  ///< told what camera rays meet
};

/// Everything paths read; made once a render. Holds references to both arguments.
class PathTracer {
public:
    PathTracer(const SceneArrays& scene, const RenderOptions& options);

    /// Traces sample `index` of pixel (x, y), full-frame coordinates, row 0 at the top, and adds it to `tally`.
    void trace(std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally) const;

    /// Where a sample's random numbers come from.
    [[nodiscard]] PathSample sampleOf(std::uint32_t x, std::uint32_t y, std::uint32_t index) const {
        return {bits_, {x | y << 16U, index, params_.spp, params_.seed}};
    }
    /// Samples of the first surface are drawn in rounds: 1 but for integrator direct.
    [[nodiscard]] std::uint32_t rounds() const;
    /// The camera ray.
    [[nodiscard]] PathState start(std::uint32_t x, std::uint32_t y, std::uint32_t index) const;
    /// Step 1. `cost` is added to where it is given.
    [[nodiscard]] std::optional<Hit> intersect(const PathState& state, SearchCost* cost = nullptr) const;
    /// Step 2: the contribution of a segment that met nothing.
    [[nodiscard]] glm::vec3 miss(const PathState& state) const;
    /// Steps 3 to 7, of the round that `state` names; what other integrators than path and direct do instead.
    [[nodiscard]] PathVertex shade(const PathState& state, const Hit& hit) const;
    /// Whether the light sample of the vertex that `state` led to does not arrive.
    [[nodiscard]] bool isOccluded(const PathState& state, const DirectLight& direct) const;

private:
    void add(PathTally& tally, const glm::vec3& contribution, const LightOrigin& origin) const;
    void countCameraRay(PathTally& tally, const PathState& camera, const std::optional<Hit>& hit) const;
    void follow(std::optional<PathState> state, std::optional<Hit> hit, PathTally& tally) const;

    const SceneArrays& scene_;
    const RenderParams& params_;
    Transport transport_;
    SamplerBits bits_;
    std::vector<FilterCell> filter_;  ///< empty: the box of one pixel
};

}  // namespace vkpt::reference
