// One path, as estimator.md writes it: as a whole, and step by step for those who look at single ones.
#pragma once
#include <limits>
#include <optional>

#include "reference/geometry.h"
#include "reference/light.h"
#include "reference/sampler.h"
#include "scene/render_options.h"

namespace vkpt::reference {

class LayerTally;

/// What paths leave behind: exact sums, and counts for statistics.
struct PathTally {
    FilmSums sums{};
    std::uint64_t refused = 0;  ///< contributions that addContribution refused
    std::uint64_t pathRays = 0, shadowRays = 0;
    LayerTally* layers = nullptr;  ///< told what camera rays meet
};

/// Where a path stands before it traces segment `bounce` (0: the camera ray).
struct PathState {
    PathSample sample;
    std::uint32_t bounce = 0;
    Ray ray;  ///< unit direction
    glm::vec3 throughput{1};
    float pdfBsdf = std::numeric_limits<float>::infinity();  ///< of the ray's direction; infinite: MIS weight 1
};

/// A light sample that is worth a shadow ray.
struct DirectLight {
    Ray shadowRay;  ///< anything at 0 < t < tMax is in the way
    float tMax = 1;
    glm::vec3 contribution{0};  ///< where nothing is
};

/// What a path does where it meets a surface: steps 3 to 7.
struct PathVertex {
    ShadingPoint point;
    std::uint32_t material = 0;
    glm::vec3 emitted{0};  ///< contribution of the surface's own light
    std::optional<DirectLight> direct;
    std::optional<PathState> next;
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
    /// The camera ray.
    [[nodiscard]] PathState start(std::uint32_t x, std::uint32_t y, std::uint32_t index) const;
    /// Step 1.
    [[nodiscard]] std::optional<Hit> intersect(const PathState& state) const;
    /// Step 2: the contribution of a segment that met nothing.
    [[nodiscard]] glm::vec3 miss(const PathState& state) const;
    /// Steps 3 to 7.
    [[nodiscard]] PathVertex shade(const PathState& state, const Hit& hit) const;
    /// Whether the light sample of the vertex that `state` led to does not arrive.
    [[nodiscard]] bool isOccluded(const PathState& state, const DirectLight& direct) const;

private:
    void countCameraRay(PathTally& tally, const PathState& camera, const std::optional<Hit>& hit) const;

    const SceneArrays& scene_;
    const RenderParams& params_;
    Lights lights_;
    SamplerBits bits_;
};

}  // namespace vkpt::reference
