// One immutable description of a render: what the command line says, resolved. Both backends read it.
#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "layout.h"
#include "registry.h"
#include "scene/aov.h"
#include "scene/light_layers.h"
#include "scene/sampler_choice.h"

namespace vkpt {

/// Path tracing with MIS through a pinhole and a box filter; size, camera and sampling are still to be set.
[[nodiscard]] constexpr RenderParams defaultParams() {
    RenderParams params{};
    params.focusDistance = 1;
    params.beta = 2;
    params.bsdfSamples = params.lightSamples = 1;
    params.aoDistance = std::numeric_limits<float>::infinity();
    params.filterRadius = 0.5F;
    return params;
}

/// The depth at which paths end under the integrator of `params`. [estimator.md, Integrators]
[[nodiscard]] constexpr std::uint32_t pathDepth(const RenderParams& params) {
    const auto integrator = static_cast<IntegratorId>(params.integrator);
    if (integrator == IntegratorId::Path) return params.maxDepth;
    return integrator == IntegratorId::Direct && params.maxDepth > 0 ? 1 : 0;
}

/// What is rendered. RenderParams carries everything both sides' estimators read.
struct RenderOptions {
    RenderParams params = defaultParams();
    SamplerChoice sampler;
    std::uint32_t sampleBegin = 0, sampleEnd = 64;  ///< range of sample indices; params.spp is the whole N
    AovSet aovs;                                    ///< layers gathered beside the picture
    LightLayers light;                              ///< the picture's own light, sorted
};

/// How a running render talks to its caller. Backends call `progress` between passes from the calling thread
/// and stop after the current pass (a range of samples over the whole film) once `stop` is set or
/// `deadline` has passed; the Film they return says which samples it holds.
struct RenderControl {
    const std::atomic<bool>* stop = nullptr;
    std::optional<std::chrono::steady_clock::time_point> deadline;
    std::function<void(std::uint64_t pathsDone, std::uint64_t pathsTotal)> progress;

    [[nodiscard]] bool shouldStop() const {
        return (stop && stop->load(std::memory_order_relaxed)) ||
               (deadline && std::chrono::steady_clock::now() >= *deadline);
    }
};

}  // namespace vkpt
