// Environment maps: where they come from, and the tables by which directions are drawn from them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "scene/scene_arrays.h"

namespace vkpt {

/// Equirectangular radiance in nits, row 0 at the top (+y), column 0 at u = 0 (-x); u = 0.25 is -z.
struct EnvironmentMap {
    std::uint32_t width = 0, height = 0;
    std::vector<glm::vec3> texels;
};

/// Reads .hdr, .exr, .pfm (linear) or .png (sRGB decoded). Non-finite and negative values become 0, with a warning in
/// the log. Throws FileError.
[[nodiscard]] EnvironmentMap readEnvironment(const std::filesystem::path& file);

/// One texel.
[[nodiscard]] EnvironmentMap constantEnvironment(const glm::vec3& radiance);

/// A photographer's studio of our own: grey cyclorama, warm key softbox at the upper left of a camera at +z, cool fill
/// on the right, rim strip behind. Its mean radiance is kStudioMean, which is what a white object reflects on average.
[[nodiscard]] EnvironmentMap studioEnvironment();
inline constexpr float kStudioMean = 0.7F;

/// Makes the map the environment of the scene: texels times `strength`, rotated by `rotationDegrees` about +y as
/// estimator.md says, and a light in proportion to its power. Replaces an environment that is there already.
/// A black map leaves the scene without one. Bounds must be in place (flatten).
void addEnvironment(SceneArrays& arrays, const EnvironmentMap& map, float strength, float rotationDegrees);

}  // namespace vkpt
