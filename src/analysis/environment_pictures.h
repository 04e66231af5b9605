// The picture of `vkpt env`.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "plot/drawing.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// The map; its scalar importance, luminance x sin(theta), with the marginal of its rows beside it; the conditional
/// densities, a row each; and where the samples fall (places are u and v, from 0 to 1).
[[nodiscard]] Drawing drawEnvironment(const std::string& name, const SceneArrays& environment,
                                      const std::vector<glm::dvec2>& places);

}  // namespace vkpt
