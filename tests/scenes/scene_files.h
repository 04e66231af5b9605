// The scenes under scenes/, their expect.json, and renders of them as the command line would set them up.
#pragma once
#include <string>
#include <vector>

#include "base/image.h"
#include "base/json.h"
#include "cli/backend.h"
#include "cli/scene_setup.h"

namespace vkpt {

/// Names of all folders under scenes/ that hold a scene.gltf, sorted.
[[nodiscard]] std::vector<std::string> sceneNames();

/// Reads scenes/NAME/expect.json.
[[nodiscard]] Json expectations(const std::string& scene);

/// Sets up scenes/NAME/scene.gltf with options of `vkpt render` ("--spp", "16", ...).
[[nodiscard]] PreparedScene prepare(const std::string& scene, std::vector<std::string> options);

/// Renders with another seed and `times` as many samples. A validation message, or a refused contribution, fails the
/// running test.
[[nodiscard]] Image renderSeed(const PreparedScene& prepared, Backend backend, std::uint32_t seed,
                               std::uint32_t times = 1);

}  // namespace vkpt
