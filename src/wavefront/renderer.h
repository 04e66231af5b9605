// The wavefront path tracer on a Vulkan device.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "film/film.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

class Device;

/// How the device is used; nothing here changes the image.
struct WavefrontConfig {
    enum class Fetch { Auto, Texel, Storage };

    std::string device;               ///< "", an index, or a part of a name
    bool validation = false;          ///< validation layers
    Fetch fetch = Fetch::Auto;        ///< how kernels read the scene
    std::uint32_t pathsInFlight = 0;  ///< 0: 262,144
    bool timings = false;             ///< measure each stage
    bool ballot = true;               ///< compact by subgroup ballot where the device has it
};

struct StageStats {
    std::string name;
    double seconds = 0;       ///< 0 unless WavefrontConfig::timings
    std::uint64_t items = 0;  ///< rays, hits, ... processed
};

struct WavefrontStats {
    std::string device, driver, fetch;
    std::vector<StageStats> stages;
    std::uint64_t paths = 0, pathRays = 0, shadowRays = 0, refused = 0, deviceBytes = 0, batches = 0;
    double uploadSeconds = 0, renderSeconds = 0, secondsToFirstPass = 0;
    std::uint64_t validationMessages = 0;
};

/// Renders one scene with one set of options, as often as wanted.
class WavefrontRenderer {
public:
    /// Picks the device, compiles the kernels, uploads the scene. Throws DeviceError where something does not fit.
    WavefrontRenderer(const SceneArrays& arrays, const RenderOptions& options, const WavefrontConfig& config);
    ~WavefrontRenderer();
    WavefrontRenderer(const WavefrontRenderer&) = delete;
    WavefrontRenderer& operator=(const WavefrontRenderer&) = delete;

    /// Renders the options' sample range; stops early, after a pass, where `control` says so.
    [[nodiscard]] Film render(const RenderControl& control, WavefrontStats* stats = nullptr);
    /// What is allocated on the device, a line each.
    [[nodiscard]] std::string memoryPlan() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vkpt
