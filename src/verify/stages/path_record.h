// Whole paths of one pixel, vertex by vertex, as either side traced them.
#pragma once
#include <optional>
#include <vector>

#include "verify/stages/device_path.h"
#include "wavefront/renderer.h"

namespace vkpt {

/// One segment and what came of it.
struct PathStep {
    reference::PathState state;
    std::optional<reference::Hit> hit;
    glm::dvec3 emitted{0};  ///< contribution of the surface met, or of the environment
    std::optional<reference::DirectLight> direct;
    bool arrives = false;  ///< the light sample does
    std::optional<reference::PathState> next;
};
/// Of integrator direct, all rounds one after the other.
using PathRecord = std::vector<PathStep>;

/// The device's record of the renderer's range of samples of one pixel (row by row), in their order.
[[nodiscard]] std::vector<PathRecord> recordDevice(const DevicePaths& paths, WavefrontRenderer& renderer,
                                                   std::uint32_t pixel);
/// The reference's record of one sample.
[[nodiscard]] PathRecord recordReference(const reference::PathTracer& tracer, std::uint32_t x, std::uint32_t y,
                                         std::uint32_t index);

}  // namespace vkpt
