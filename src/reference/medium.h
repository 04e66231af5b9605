// What is inside of dielectrics: absorption without scattering.
#pragma once
#include <cmath>

#include "scene/scene_arrays.h"

namespace vkpt::reference {

/// Share of light that is left after `distance` metres (may be infinite) inside of a dielectric, by the law of Beer and
/// Lambert. `medium`: its material, or kNone outside of all.
[[nodiscard]] inline glm::vec3 transmittance(const SceneArrays& scene, std::uint32_t medium, float distance) {
    glm::vec3 left(1);
    if (medium == kNone) return left;
    const glm::vec3& absorption = scene.bsdfs[medium].diffuse;
    for (int i = 0; i < 3; ++i)
        if (absorption[i] != 0) left[i] = std::exp(-absorption[i] * distance);
    return left;
}

}  // namespace vkpt::reference
