// A sphere of one BSDF in the built-in studio.
#pragma once
#include "base/image.h"
#include "scene/bsdf_spec.h"

namespace vkpt {

/// Three display-encoded channels, `side` x `side` pixels, by the CPU reference.
[[nodiscard]] Image renderBsdfSphere(const BsdfSpec& spec, bool multiscatter, std::uint32_t side, std::uint32_t spp);

}  // namespace vkpt
