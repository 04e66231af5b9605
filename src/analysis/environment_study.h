// An environment map as a light: where its importance lies, where samples fall, what that gains. Shown by `vkpt env`.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "analysis/studies.h"
#include "scene/environment.h"

namespace vkpt {

struct EnvironmentStudyRequest {
    std::string name;
    EnvironmentMap map;
    SamplerChoice sampler;
    std::uint32_t count = 256, seed = 0;  ///< directions that are drawn and shown
    bool picture = true;
    /// Called with texels, 0 and then after each row; one call at a time.
    std::function<void(std::uint64_t done, std::uint64_t total)> progress;
};

/// Sizes, density and the variance of one sample, by importance and uniform over the sphere, of three integrals: light
/// from everywhere, and irradiance of surfaces that look up and towards -z. Throws Error (usage) for a black map.
[[nodiscard]] Study studyEnvironment(const EnvironmentStudyRequest& request);

}  // namespace vkpt
