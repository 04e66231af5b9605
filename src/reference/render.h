// The CPU reference: plain loops over pixels, in parallel, independent of the shaders.
#pragma once
#include <cstdint>

#include "film/film.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct ReferenceConfig {
    unsigned threads = 0;  ///< 0: as many as the machine has
};

struct ReferenceStats {
    std::uint64_t paths = 0, pathRays = 0, shadowRays = 0;
    std::uint32_t passes = 0;
    double seconds = 0;  ///< wall time of all passes
};

/// Renders samples [options.sampleBegin, options.sampleEnd) of every pixel of a scene whose BVH is built. The film
/// depends on neither threads nor passes. A pass is a range of samples over the whole film; at least one is made,
/// and the film's ranges say where `control` stopped. Throws Error (Usage) for an empty frame or range, or a
/// frame beyond 65,536 pixels a side.
[[nodiscard]] Film renderReference(const SceneArrays& scene, const RenderOptions& options,
                                   const RenderControl& control = {}, const ReferenceConfig& config = {},
                                   ReferenceStats* stats = nullptr);

}  // namespace vkpt
