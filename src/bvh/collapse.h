// Binary tree to wide tree: which subtrees become nodes, leaves, or are dissolved into their parent's slots.
// The choice of least SAH cost is found bottom-up by dynamic programming. [Ylitie 17]
#pragma once
#include <array>
#include <span>

#include "bvh/binary_tree.h"
#include "bvh/bounds.h"
#include "bvh/wide_node.h"

namespace vkpt {

/// Best ways to represent one subtree by at most i + 1 slots, i = 0 … 6.
struct Forest {
    Bounds box;
    std::array<float, 7> cost;           ///< surface area cost
    std::array<std::uint32_t, 7> nodes;  ///< wide nodes used
    std::array<std::uint32_t, 7> depth;  ///< levels of wide nodes
};

/// How subtrees are chosen: by cost, or three binary levels to a node, which bounds the depth.
enum class CollapseRule : std::uint8_t { Cost, Balanced };

[[nodiscard]] Forest forestOfItem(const Bounds& box, float areaScale, float itemCost);

/// Forest of a node of `count` items from those of its children; writes its bounds, choices and size.
[[nodiscard]] Forest mergeForests(const Forest& left, const Forest& right, std::uint32_t count, float areaScale,
                                  const TreeCosts& costs, CollapseRule rule, BinaryNode& node);

/// The wide tree of `tree` as if its root were an inner node whatever the costs: nodes and levels.
[[nodiscard]] TreeSummary summarise(const BinaryNode& root, const Forest& left, const Forest& right);

/// One tree on its way to wide nodes.
struct WideTarget {
    std::span<const ItemRef> items;
    std::span<const BinaryNode> nodes;
    std::span<WideNode> wide;        ///< the tree's nodes, root first
    std::span<std::uint32_t> order;  ///< receives the items' indices in leaf order
    std::uint32_t firstNode = 0;     ///< index of wide[0] in the whole array
    std::uint32_t firstItem = 0;     ///< index of order[0] in the whole array
};

/// Writes all nodes and the order of items. `items` may be empty (a node of empty slots) or single. Parallel.
void emitWideTree(const WideTarget& target);

}  // namespace vkpt
