// The binary tree that wide nodes are collapsed from.
#pragma once
#include <span>

#include "bvh/bounds.h"

namespace vkpt {

/// Inner node over a range of two items or more; a single item has no node. A tree of n items has n - 1 nodes: that of
/// [begin, end) is followed by those of [begin, split), then those of [split, end).
struct BinaryNode {
    float lo[3], hi[3];
    std::uint32_t split;      ///< first item of the right child
    std::uint32_t choices;    ///< see collapse.h
    std::uint32_t wideNodes;  ///< nodes of the wide tree that this subtree becomes; 0 for a leaf
};

/// A range of items with its node (meaningless for a single item).
struct Subtree {
    std::uint32_t begin, end, node;

    [[nodiscard]] std::uint32_t count() const { return end - begin; }
    [[nodiscard]] Subtree left(std::uint32_t split) const { return {begin, split, node + 1}; }
    [[nodiscard]] Subtree right(std::uint32_t split) const { return {split, end, node + (split - begin)}; }
};

struct TreeCosts {
    float node = 1, item = 1;
    std::uint32_t maxDepth = 1;  ///< levels of wide nodes
};

struct TreeSummary {
    std::uint32_t wideNodes = 1;
    std::uint32_t depth = 1;  ///< levels of wide nodes
    bool balanced = false;    ///< built without the SAH's choice of depth, to keep to maxDepth
};

/// Sorts `items` (at least 2) into a tree and writes its items.size() - 1 nodes, with the choices of the collapse.
/// Parallel. Requires items.size() <= 8^maxDepth.
[[nodiscard]] TreeSummary buildBinaryTree(std::span<ItemRef> items, std::span<BinaryNode> nodes,
                                          const TreeCosts& costs);

}  // namespace vkpt
