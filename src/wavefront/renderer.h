// The wavefront path tracer on a Vulkan device.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "film/film.h"
#include "gpu/spirv_source.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"
#include "wavefront/layout.h"

namespace vkpt {

class Device;

/// How the device is used; nothing here changes the image.
struct WavefrontConfig {
    enum class Fetch { Auto, Texel, Storage };

    std::string device;               ///< "", an index, or a part of a name
    bool validation = false;          ///< validation layers
    Fetch fetch = Fetch::Auto;        ///< how kernels read the scene
    std::uint32_t pathsInFlight = 0;  ///< 0: 65,536 where kernels run on the CPU, else 262,144
    bool timings = false;             ///< measure each stage
    bool ballot = true;               ///< compact by subgroup ballot where the device has it
    SpirvSource kernels{};            ///< empty: those of shaders/kernels
};

/// The device between two kernels of a batch.
struct StageSnapshot {
    Stage stage = Stage::Generate;        ///< the one that has just run
    BatchParams batch;                    ///< its push constants
    std::vector<uvec4> state;             ///< as StateArray and slot say: see word()
    std::vector<std::uint32_t> counters;  ///< of queues, then the queues themselves: see queue()

    [[nodiscard]] const uvec4& word(StateArray array, std::uint32_t slot) const {
        return state[static_cast<std::size_t>(array) * batch.capacity + slot];
    }
    /// The slots a queue holds.
    [[nodiscard]] std::span<const std::uint32_t> queue(std::uint32_t bounce, Queue queue) const {
        return {counters.data() + queueArrayOffset(bounce, queue, batch.capacity), queueSize(bounce, queue)};
    }
    [[nodiscard]] std::uint32_t queueSize(std::uint32_t bounce, Queue queue) const {
        return counters[queueCounterOffset(bounce, queue) / 4 + 3];
    }
};
using StageObserver = std::function<void(const StageSnapshot&)>;

struct StageStats {
    std::string name;
    double seconds = 0;       ///< 0 unless WavefrontConfig::timings
    std::uint64_t items = 0;  ///< rays, hits, ... processed
};

struct WavefrontStats {
    std::string device, driver, fetch;
    std::vector<StageStats> stages;
    std::uint64_t paths = 0, pathRays = 0, shadowRays = 0, refused = 0, deviceBytes = 0, batches = 0;
    std::uint64_t refusedInLayers = 0;
    double uploadSeconds = 0, renderSeconds = 0, secondsToFirstPass = 0;
    std::uint64_t validationMessages = 0;
};

/// Some pixels of a film, as a batch left them.
struct ObservedFilm {
    std::vector<FilmSums> sums;
    std::vector<uvec4> layers;  ///< FilmLayout::words() a pixel
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
    /// From now on renders samples [begin, end) under `seed`; the other options stay, spp among them, which is the end
    /// of what may be selected.
    void select(std::uint32_t seed, std::uint32_t begin, std::uint32_t end);
    /// Renders the options' sample range of `pixelCount` pixels from `firstPixel` on (row by row, within one band of
    /// the film) in one batch, and shows `observer` the device after every kernel; where shade traces shadow rays
    /// itself, a variant runs that has a stage for them. Throws Error (Usage) where the paths exceed
    /// WavefrontConfig::pathsInFlight or the band.
    [[nodiscard]] ObservedFilm observe(std::uint32_t firstPixel, std::uint32_t pixelCount,
                                       const StageObserver& observer);
    /// What is allocated on the device, a line each.
    [[nodiscard]] std::string memoryPlan() const;
    /// Warnings and errors of the validation layers so far (0 without validation).
    [[nodiscard]] std::uint64_t validationMessages() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace vkpt
