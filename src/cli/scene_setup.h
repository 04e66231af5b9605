// From the command line's options to what a renderer takes.
#pragma once
#include <filesystem>
#include <string>

#include "base/json.h"
#include "bvh/build.h"
#include "cli/options.h"
#include "scene/environment.h"
#include "scene/render_options.h"
#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// Everything one render needs, and what it came from.
struct PreparedScene {
    std::filesystem::path file;
    int sceneIndex = -1;
    SceneArrays arrays;  ///< environment and BVH included
    RenderOptions options;
    BvhStats bvh;
    std::string environment;  ///< "none", "studio", "R,G,B" or the name of a file
    float envRotation = 0, envStrength = 1;
    Json seconds;  ///< of each step
};

/// Reads or makes what --env names; an empty map for none and where the choice is left to the scene. Throws FileError.
[[nodiscard]] EnvironmentMap makeEnvironment(const EnvironmentChoice& choice);
/// "none", "studio", "R,G,B" or the name of the file.
[[nodiscard]] std::string environmentName(const EnvironmentChoice& choice);

/// Imports, flattens, lights, frames and builds. Warnings go to the log. Throws FileError for a faulty file and
/// Error(Usage), naming the option, for a choice the scene does not offer.
[[nodiscard]] PreparedScene prepareScene(const SceneOptions& scene, const SamplingOptions& sampling);

}  // namespace vkpt
