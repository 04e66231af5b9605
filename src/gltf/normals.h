// Normals where a file has none, or has bad ones.
#pragma once
#include <cstddef>

#include "scene/scene.h"

namespace vkpt::gltf {

/// A direction for what has none: any unit vector serves.
inline constexpr glm::vec3 kAnyNormal{0, 0, 1};

/// Gives every triangle vertices of its own with its geometric normal. Tangents are dropped: they would belong to
/// other normals. [glTF 2.0, §3.7.2.1]
void makeFlat(Primitive& primitive);

/// Scales normals to unit length. Those that are zero or not finite become the area-weighted mean of the triangles
/// around the vertex. Returns how many were replaced.
std::size_t repairNormals(Primitive& primitive);

}  // namespace vkpt::gltf
