// Both renderers behind one face.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/json.h"
#include "cli/options.h"
#include "film/film.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// What one call of render did, in the words of either renderer.
struct RenderReport {
    std::string backend, device, driver, fetch;
    std::uint64_t paths = 0, pathRays = 0, shadowRays = 0, deviceBytes = 0, validationMessages = 0;
    double uploadSeconds = 0, renderSeconds = 0;
    std::vector<StageStats> stages;  ///< empty where the renderer has none
};

/// Adds counts and times of a later call of the same renderer.
void addReport(RenderReport& into, const RenderReport& later);

/// Paths, rays and stages with their rates, for --stats and bench.
[[nodiscard]] Json reportJson(const RenderReport& report);

class SceneRenderer {
public:
    SceneRenderer() = default;
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;
    virtual ~SceneRenderer() = default;

    /// Renders a range of samples, or its beginning where `control` stops it.
    [[nodiscard]] virtual Film render(const SampleRange& range, const RenderControl& control, RenderReport& report) = 0;
    /// What is allocated on the device; empty for the CPU.
    [[nodiscard]] virtual std::string memoryPlan() const = 0;
};

/// `arrays` and `options` must outlive the renderer. `timings`: measure each stage, at some cost.
/// Throws DeviceError where the Vulkan device is absent or too small.
[[nodiscard]] std::unique_ptr<SceneRenderer> makeRenderer(const SceneArrays& arrays, const RenderOptions& options,
                                                          const BackendOptions& backend, bool timings);

}  // namespace vkpt
