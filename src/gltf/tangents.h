// Tangents where a normal map needs them and the file has none. [Mikkelsen 08]
#pragma once
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace vkpt::gltf {

/// Makes tangents in MikkTSpace's sense from positions, normals and texture coordinates `uvSet`. Vertices that are
/// equal in all three count as one; around it, triangles that share an edge and the same handedness average their
/// tangents, weighted by the corner's angle in the normal's tangent plane. Vertices that then need several tangents are
/// split. w follows glTF: bitangent = cross(normal, tangent) * w points up in the image (towards lower V).
/// Without usable texture coordinates the tangent is any direction across the normal. [Mikkelsen 08, §3; glTF 2.0,
/// §3.7.2.1]
void makeTangents(Primitive& primitive, std::uint32_t uvSet);

}  // namespace vkpt::gltf
