// What checks work on: a device with its probes, and one scene with its two renderers.
#pragma once
#include <memory>

#include "gpu/device.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"
#include "verify/prober.h"
#include "wavefront/renderer.h"

namespace vkpt {

struct VerifyConfig {
    WavefrontConfig wavefront;        ///< device, validation, fetch form, kernels
    SpirvSource probes = probeSpirv;  ///< code of shaders/probes
};

/// Holds references to scene and options. Device and renderer are made when a check first asks for them.
class VerifyContext {
public:
    VerifyContext(const SceneArrays& scene, const RenderOptions& options, VerifyConfig config);

    [[nodiscard]] Prober& prober();
    /// Messages of the validation layers so far.
    [[nodiscard]] std::uint64_t validationMessages() const;

private:
    const SceneArrays& scene_;
    const RenderOptions& options_;
    VerifyConfig config_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<Prober> prober_;
};

}  // namespace vkpt
