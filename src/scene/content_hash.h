// Hashes of everything a renderer reads of a scene.
#pragma once
#include <string>

#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// 32 hexadecimal digits each. Equal: both renderers read the same bits, whatever files they came from.
struct SceneHashes {
    std::string geometry;     ///< triangles, vertices, instances, nodes
    std::string materials;    ///< materials and textures
    std::string lights;       ///< but the environment
    std::string environment;  ///< texels, tables, rotation
};

[[nodiscard]] SceneHashes hashScene(const SceneArrays& arrays);

/// Of all that RenderOptions says of the image but the range of samples.
[[nodiscard]] std::string hashOptions(const RenderOptions& options);

}  // namespace vkpt
