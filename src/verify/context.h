// What checks work on: a device with its probes, and one scene with its two renderers.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "compare/replicates.h"
#include "gpu/device.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"
#include "verify/images/path_differences.h"
#include "verify/prober.h"
#include "wavefront/renderer.h"

namespace vkpt {

class StageWalk;

struct VerifyConfig {
    WavefrontConfig wavefront;        ///< device, validation, fetch form, kernels
    SpirvSource probes = probeSpirv;  ///< code of shaders/probes
    std::uint32_t replicates = 32;    ///< images a side of the last rung
    unsigned threads = 0;             ///< of the reference; 0: all
    /// Called now and then during long checks.
    std::function<void(std::uint64_t done, std::uint64_t total)> progress{};
};

/// Films of the same random numbers.
struct SameSeedImages {
    Film device, reference;
    PathDifferences differences;
};

/// Holds references to scene and options. Device and renderer are made when a check first asks for them.
class VerifyContext {
public:
    VerifyContext(const SceneArrays& scene, const RenderOptions& options, VerifyConfig config);

    ~VerifyContext();
    VerifyContext(const VerifyContext&) = delete;
    VerifyContext& operator=(const VerifyContext&) = delete;

    [[nodiscard]] const VerifyConfig& config() const { return config_; }
    [[nodiscard]] const SceneArrays& scene() const { return scene_; }
    [[nodiscard]] const RenderOptions& options() const { return options_; }

    [[nodiscard]] Prober& prober();
    /// Of the scene; batches are small, since much is read back after each.
    [[nodiscard]] WavefrontRenderer& renderer();
    /// The last sample of (at most 2^14 of) the scene's pixels, walked through once.
    [[nodiscard]] const StageWalk& stages();
    /// The options' samples of the whole scene on both sides, rendered once.
    [[nodiscard]] const SameSeedImages& sameSeed();
    /// Replicates of the options' samples under other seeds, rendered once.
    [[nodiscard]] const ReplicateResult& replicates();
    /// What there is of the two so far.
    [[nodiscard]] const std::optional<SameSeedImages>& sameSeedSoFar() const { return sameSeed_; }
    [[nodiscard]] const std::optional<ReplicateResult>& replicatesSoFar() const { return replicates_; }
    /// Messages of the validation layers so far.
    [[nodiscard]] std::uint64_t validationMessages() const;

private:
    const SceneArrays& scene_;
    const RenderOptions& options_;
    VerifyConfig config_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<Prober> prober_;
    std::unique_ptr<WavefrontRenderer> renderer_;
    std::unique_ptr<StageWalk> stages_;
    std::optional<SameSeedImages> sameSeed_;
    std::optional<ReplicateResult> replicates_;
};

}  // namespace vkpt
