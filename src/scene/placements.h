// Which meshes are baked to world space, which are shared between their places, and the list of jobs that follows.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/flatten_geometry.h"

namespace vkpt {

/// One primitive to be written once into the flat arrays, through one matrix.
struct GeometryJob {
    const Primitive* primitive = nullptr;
    glm::mat4 matrix{1};       ///< world from object; identity or a mirror where the mesh is shared
    std::uint32_t object = 0;  ///< index into Scene::instances; 0 where the mesh is shared
    std::uint32_t range = 0;   ///< index into SceneArrays::meshRanges
    std::uint32_t firstVertex = 0;
};

/// A mesh instance that places a shared range. `matrix` has a positive determinant.
struct SharedPlacement {
    std::uint32_t range = 0;
    std::uint32_t object = 0;
    glm::mat4 matrix{1};
};

struct GeometryPlan {
    std::vector<GeometryJob> jobs;  ///< ordered by range
    std::vector<SharedPlacement> shared;
    std::uint32_t ranges = 1;  ///< range 0 is the baked geometry
    std::uint64_t vertices = 0, droppedInstances = 0;
};

[[nodiscard]] GeometryPlan planGeometry(const Scene& scene, const FlattenOptions& options,
                                        const std::vector<MaterialTraits>& traits);

}  // namespace vkpt
