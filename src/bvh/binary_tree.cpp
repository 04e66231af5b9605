#include "bvh/binary_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "bvh/collapse.h"
#include "bvh/split.h"

namespace vkpt {

namespace {

constexpr std::size_t kTaskItems = 2048;       // smaller subtrees are built by one thread
constexpr std::uint32_t kMaxBinaryDepth = 64;  // bounds the recursion, whatever the geometry

class Builder {
public:
    Builder(std::span<ItemRef> items, std::span<BinaryNode> nodes, const TreeCosts& costs, CollapseRule rule,
            float areaScale)
        : items_(items),
          nodes_(nodes),
          costs_(costs),
          rule_(rule),
          maxDepth_(rule == CollapseRule::Cost ? kMaxBinaryDepth : 3 * costs.maxDepth),
          areaScale_(areaScale) {}

    TreeSummary buildRoot() {
        const Subtree root{0, static_cast<std::uint32_t>(items_.size()), 0};
        Forest left, right;
        buildChildren(root, {items_, centroidBoundsOf(items_)}, 0, left, right);
        (void)mergeForests(left, right, root.count(), areaScale_, costs_, rule_, nodes_[0]);
        return summarise(nodes_[0], left, right);
    }

private:
    void buildChildren(const Subtree& tree, const SplitRange& range, std::uint32_t depth, Forest& left, Forest& right) {
        const std::uint32_t levelsByCount = std::bit_width(tree.count() - 1);
        const SplitResult split =
            depth + levelsByCount < maxDepth_ ? splitBySah(range, areaScale_) : splitByCount(range);
        const std::uint32_t at = tree.begin + static_cast<std::uint32_t>(split.left.items.size());
        nodes_[tree.node].split = at;
        const auto buildLeft = [&] { left = build(tree.left(at), split.left, depth + 1); };
        const auto buildRight = [&] { right = build(tree.right(at), split.right, depth + 1); };
        if (tree.count() >= kTaskItems) {
            tbb::parallel_invoke(buildLeft, buildRight);
        } else {
            buildLeft();
            buildRight();
        }
    }

    Forest build(const Subtree& tree, const SplitRange& range, std::uint32_t depth) {
        if (tree.count() == 1) return forestOfItem(range.items[0].box(), areaScale_, costs_.item);
        Forest left, right;
        buildChildren(tree, range, depth, left, right);
        return mergeForests(left, right, tree.count(), areaScale_, costs_, rule_, nodes_[tree.node]);
    }

    std::span<ItemRef> items_;
    std::span<BinaryNode> nodes_;
    const TreeCosts& costs_;
    CollapseRule rule_;
    std::uint32_t maxDepth_;
    float areaScale_;
};

/// A power of two that brings the largest extent of the box near 1.
float areaScaleOf(const Bounds& box) {
    const Float4 extent = box.hi - box.lo;
    const float largest = std::max(extent[0], std::max(extent[1], extent[2]));
    return largest > 0 ? std::exp2(static_cast<float>(std::clamp(-std::ilogb(largest), -126, 126))) : 1.0F;
}

}  // namespace

TreeSummary buildBinaryTree(std::span<ItemRef> items, std::span<BinaryNode> nodes, const TreeCosts& costs) {
    assert(items.size() >= 2 && nodes.size() + 1 >= items.size());
    const float areaScale = areaScaleOf(boundsOf(items));
    TreeSummary summary = Builder(items, nodes, costs, CollapseRule::Cost, areaScale).buildRoot();
    if (summary.depth > costs.maxDepth) {
        summary = Builder(items, nodes, costs, CollapseRule::Balanced, areaScale).buildRoot();
        summary.balanced = true;
    }
    return summary;
}

}  // namespace vkpt
