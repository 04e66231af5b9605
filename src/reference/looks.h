// Integrators that ask one thing of the surface that the camera ray met: ambient occlusion, and looks for debugging.
#pragma once
#include "reference/surface.h"

namespace vkpt::reference {

/// Whether `integrator` is one of them. Then a camera ray that misses is transparent.
[[nodiscard]] constexpr bool isLook(std::uint32_t integrator) {
    return integrator >= static_cast<std::uint32_t>(IntegratorId::Ao);
}

/// What the integrator of `transport.params` makes of a surface: `emitted` alone; of `ao`, `direct` alone. `cost`,
/// which is a matter of the search, is none of this: it yields nothing.
[[nodiscard]] PathVertex look(const Transport& transport, const PathState& camera, const Hit& hit);

/// Distance of a point as the integrator and the layer `depth` tell it.
[[nodiscard]] float depthOf(const RenderParams& params, const glm::vec3& position);

}  // namespace vkpt::reference
