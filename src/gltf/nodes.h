// The node hierarchy: what a scene places, and where. [glTF 2.0, §3.5]
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "gltf/document.h"

namespace vkpt::gltf {

/// A node that carries something.
struct PlacedNode {
    std::size_t node = 0;
    glm::dmat4 world{1};  ///< world from the node's own space
};

/// All nodes of the scene in depth-first order of the file, with their transforms. `scene` is -1 for the default scene
/// (else the first, else, in a file without scenes, every root node). Throws FileError for a scene that does not exist,
/// a node with two parents, a cycle, or a transform that is not finite.
[[nodiscard]] std::vector<PlacedNode> placeNodes(const Document& document, int scene,
                                                 std::vector<std::string>& warnings);

/// `world` with axes of unit length, as cameras and lights are placed: their scale means nothing.
[[nodiscard]] glm::mat4 withoutScale(const glm::dmat4& world);

}  // namespace vkpt::gltf
