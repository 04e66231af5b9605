// The geometric part of flatten.
#pragma once
#include <cstdint>
#include <vector>

#include "scene/flatten.h"

namespace vkpt {

/// What flattenGeometry needs to know of a material.
struct MaterialTraits {
    bool used = false;          ///< by a placed primitive
    bool emissive = false;      ///< emits by itself: never unlit
    bool vertexColor = false;   ///< some primitive with it has COLOR_0
    float minTextureAlpha = 1;  ///< lower bound of the base colour texture's alpha
};

/// Fills triangles, vertices, vertexExtras, meshRanges, instances, bounds and the geometric features.
void flattenGeometry(const Scene& scene, const FlattenOptions& options, const std::vector<MaterialTraits>& traits,
                     SceneArrays& arrays);

}  // namespace vkpt
