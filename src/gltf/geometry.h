// Mesh primitives: accessors -> arrays of attributes and triangles.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gltf/document.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// What a primitive that is no triangles would have drawn.
struct Skipped {
    std::uint64_t points = 0, lines = 0;
};

/// Reads meshes[mesh].primitives[index]: normals made flat where the file has none, tangents made where `material` has
/// a normal map. Primitive::material is left for the caller. Empty where it draws no triangle; points and lines are
/// counted in `skipped`. Throws FileError on anything that does not fit together.
[[nodiscard]] std::optional<Primitive> readPrimitive(const Document& document, std::size_t mesh, std::size_t index,
                                                     const Material& material, Skipped& skipped,
                                                     std::vector<std::string>& warnings);

}  // namespace vkpt::gltf
