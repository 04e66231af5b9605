// Scene -> SceneArrays: places meshes, packs attributes, lays out materials and texels, makes the light table.
#pragma once
#include <cstdint>

#include "scene/scene.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct FlattenOptions {
    bool instancing = true;
    /// A mesh placed several times is shared between its places if baking would add at least this many triangles.
    std::uint64_t instancingThreshold = 4096;
    bool multiscatter = false;  ///< compensate what facets lose by interreflection
};

/// Flattens the scene: geometry, materials, textures, emissive triangles and punctual lights; no environment yet
/// (addEnvironment) and no BVH. The result depends on the scene alone, not on the number of threads.
///
/// Triangles come in source order: baked ones first (instances, primitives, triangles as in the file), then each
/// shared mesh. A mirrored placement of a shared mesh uses a mirrored copy, so that every InstanceRecord keeps
/// its orientation (positive determinant). Emissive meshes are always baked. Triangles without an area that float
/// arithmetic can normalise, or with non-finite corners, are dropped and counted.
/// Throws FileError where the scene exceeds what the records can index.
[[nodiscard]] SceneArrays flatten(const Scene& scene, const FlattenOptions& options = {});

}  // namespace vkpt
