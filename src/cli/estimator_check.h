// What options of light transport do together: contradictions, options that alter nothing, light that stays unfound.
#pragma once
#include <string>
#include <vector>

#include "cli/options.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// Throws a usage error where nothing would be computed, and for layers that the integrator does not have.
void checkEstimator(const SamplingOptions& sampling);

/// A line for each option that is not at its default and yet alters nothing: "--focus has no effect without
/// --aperture".
[[nodiscard]] std::vector<std::string> idleOptions(const SceneOptions& scene, const SamplingOptions& sampling);

/// A line on lights of the scene that the estimator cannot find; empty where it finds all.
[[nodiscard]] std::string unfoundLight(const SceneArrays& arrays, const RenderParams& params);

}  // namespace vkpt
