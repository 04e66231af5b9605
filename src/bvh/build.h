// Bounding volume hierarchies over everything in SceneArrays.
#pragma once
#include <cstddef>
#include <cstdint>

#include "bvh/wide_node.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// Costs relative to each other; only their ratios matter.
struct BvhConfig {
    float nodeCost = 1.0F;      ///< testing the eight boxes of a node
    float triangleCost = 1.0F;  ///< testing one triangle: as much as a node where invocations run in lockstep
    float instanceCost = 4.0F;  ///< entering one instance: the transformation and the upper nodes of its mesh
    std::uint32_t maxMeshDepth = kMaxMeshDepth;  ///< levels of a bottom-level tree, at most kMaxMeshDepth
    std::uint32_t maxTopDepth = kMaxTopDepth;    ///< levels of the top-level tree, at most kMaxTopDepth
};

/// What was built and how well. Depths count levels of nodes; a single node has depth 1.
struct BvhStats {
    double seconds = 0;
    std::size_t nodes = 0, topNodes = 0;
    std::size_t leaves = 0;          ///< slots that hold items
    std::size_t bytes = 0;           ///< of all nodes
    std::size_t temporaryBytes = 0;  ///< most that the builder held beside its input and output
    std::uint32_t depth = 0;         ///< of the whole: top level and deepest mesh together
    double sahCost = 0;              ///< expected cost of a ray that meets the root's box, from the decoded boxes
    double itemsPerLeaf = 0;
    double childrenPerNode = 0;       ///< of kWideNodeSlots
    double bytesPerTriangle = 0;      ///< of nodes, without the triangles themselves
    std::uint32_t balancedTrees = 0;  ///< trees rebuilt balanced, since the SAH alone went too deep
};

/// Builds a tree over each MeshRange and, where there are instances, a top-level tree over those. Parallel (oneTBB, the
/// caller's arena); the result does not depend on the number of threads.
///
/// Fills arrays.nodes, arrays.bvhDepth and arrays.rootNode, which is 0. Puts triangles in leaf order within their
/// range, and instances (with instanceMesh and their rootNode) in leaf order, those of empty meshes last and in no
/// leaf. Points each triangle light at its triangle's new place. A mesh without triangles, and an empty scene, get one
/// node of empty slots. Triangles with a corner that is not finite, or beyond 1e37, cannot be met and are kept in an
/// arbitrary leaf. Mesh ranges must be disjoint; without instances only meshRanges[0] is reachable.
void buildBvh(SceneArrays& arrays, const BvhConfig& config = {}, BvhStats* stats = nullptr);

}  // namespace vkpt
