#include "bvh/collapse.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "bvh/encode.h"

namespace vkpt {

namespace {

// BinaryNode::choices: for j = 2 … 8 slots, three bits: how many of them go to the left child, or 0 where j - 1 slots
// cost no more; then a bit: in one slot the subtree is a leaf.
constexpr std::uint32_t kLeafBit = 1U << 21;
constexpr std::uint32_t kEmitTaskItems = 4096;  // smaller subtrees are written by one thread

std::uint32_t choiceShift(std::uint32_t slots) { return 3 * (slots - 2); }
std::uint32_t leftSlots(std::uint32_t choices, std::uint32_t slots) { return choices >> choiceShift(slots) & 7U; }

/// Cheapest way to spread `slots` slots over both children; returns the left one's share.
std::uint32_t bestShare(const Forest& left, const Forest& right, std::uint32_t slots, float& cost) {
    std::uint32_t share = 1;
    cost = left.cost[0] + right.cost[slots - 2];
    for (std::uint32_t k = 2; k < slots; ++k) {
        const float c = left.cost[k - 1] + right.cost[slots - k - 1];
        if (c < cost) cost = c, share = k;
    }
    return share;
}

/// A child of a wide node to be.
struct Child {
    Subtree tree;
    bool leaf;
    Bounds box;
};

struct Children {
    std::array<Child, kWideNodeSlots> child;
    std::uint32_t count = 0;
};

class Emitter {
public:
    explicit Emitter(const WideTarget& target) : target_(target) {}

    /// Writes the node of `tree` at wide[index]; nodes below it at wide[below] onwards, items at order[items] onwards.
    void emit(const Subtree& tree, std::uint32_t index, std::uint32_t below, std::uint32_t items) const {
        Children children;
        if (tree.count() == 1) {
            gather(tree, 1, children);
        } else if (tree.count() > 1) {
            spread(tree, kWideNodeSlots, children);
        }
        std::array<const Child*, kWideNodeSlots> inSlot{};
        place(children, inSlot);
        write(inSlot, index, below, items);
        for (const Child* child : inSlot) {
            if (child == nullptr || !child->leaf) continue;
            for (std::uint32_t i = child->tree.begin; i < child->tree.end; ++i) {
                target_.order[items++] = target_.items[i].index();
            }
        }
        descend(inSlot, below, items, tree.count() >= kEmitTaskItems);
    }

private:
    [[nodiscard]] Bounds boxOf(const Subtree& tree) const {
        if (tree.count() == 1) return target_.items[tree.begin].box();
        const BinaryNode& node = target_.nodes[tree.node];
        return {Float4{node.lo[0], node.lo[1], node.lo[2], 0}, Float4{node.hi[0], node.hi[1], node.hi[2], 0}};
    }

    /// Appends what represents `tree` in at most `slots` slots.
    void gather(const Subtree& tree, std::uint32_t slots, Children& out) const {
        if (tree.count() == 1) {
            out.child[out.count++] = {tree, true, boxOf(tree)};
            return;
        }
        const std::uint32_t choices = target_.nodes[tree.node].choices;
        while (slots > 1 && leftSlots(choices, slots) == 0) --slots;
        if (slots > 1) return spread(tree, slots, out);
        out.child[out.count++] = {tree, (choices & kLeafBit) != 0, boxOf(tree)};
    }

    void spread(const Subtree& tree, std::uint32_t slots, Children& out) const {
        const BinaryNode& node = target_.nodes[tree.node];
        const std::uint32_t k = leftSlots(node.choices, slots);
        gather(tree.left(node.split), k, out);
        gather(tree.right(node.split), slots - k, out);
    }

    static void place(const Children& children, std::array<const Child*, kWideNodeSlots>& inSlot) {
        std::array<Bounds, kWideNodeSlots> boxes;
        for (std::uint32_t c = 0; c < children.count; ++c) boxes[c] = children.child[c].box;
        const auto slotOf = assignSlots(std::span<const Bounds>(boxes.data(), children.count));
        for (std::uint32_t c = 0; c < children.count; ++c) inSlot[slotOf[c]] = &children.child[c];
    }

    void write(const std::array<const Child*, kWideNodeSlots>& inSlot, std::uint32_t index, std::uint32_t below,
               std::uint32_t items) const {
        std::array<WideSlot, kWideNodeSlots> slots;
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            if (const Child* child = inSlot[s]) {
                slots[s] = {child->leaf ? WideChildKind::Leaf : WideChildKind::Inner, child->tree.count(), child->box};
            }
        }
        target_.wide[index] = encodeWideNode(slots, target_.firstNode + below, target_.firstItem + items);
    }

    /// The inner children come first among the nodes below, then each one's own descendants.
    void descend(const std::array<const Child*, kWideNodeSlots>& inSlot, std::uint32_t below, std::uint32_t items,
                 bool parallel) const {
        struct Job {
            Subtree tree;
            std::uint32_t index, below, items;
        };
        std::array<Job, kWideNodeSlots> jobs;
        std::uint32_t count = 0, index = below;
        for (const Child* child : inSlot) below += child != nullptr && !child->leaf ? 1U : 0U;
        for (const Child* child : inSlot) {
            if (child == nullptr || child->leaf) continue;
            jobs[count++] = {child->tree, index++, below, items};
            below += target_.nodes[child->tree.node].wideNodes - 1;
            items += child->tree.count();
        }
        const auto run = [&](std::uint32_t j) { emit(jobs[j].tree, jobs[j].index, jobs[j].below, jobs[j].items); };
        if (parallel) {
            tbb::parallel_for(std::uint32_t{0}, count, run);
        } else {
            for (std::uint32_t j = 0; j < count; ++j) run(j);
        }
    }

    const WideTarget& target_;
};

}  // namespace

Forest forestOfItem(const Bounds& box, float areaScale, float itemCost) {
    Forest forest{box, {}, {}, {}};
    forest.cost.fill(halfArea(box, areaScale) * itemCost);
    return forest;
}

Forest mergeForests(const Forest& left, const Forest& right, std::uint32_t count, float areaScale,
                    const TreeCosts& costs, CollapseRule rule, BinaryNode& node) {
    Forest forest{left.box, {}, {}, {}};
    forest.box.grow(right.box);
    const float area = halfArea(forest.box, areaScale);
    const bool mayBeLeaf = count <= kWideNodeLeafItems, balanced = rule == CollapseRule::Balanced;
    std::array<std::uint32_t, kWideNodeSlots + 1> share{};
    std::array<float, kWideNodeSlots + 1> spreadCost{};
    for (std::uint32_t j = 2; j <= kWideNodeSlots; ++j) {
        share[j] = bestShare(left, right, j, spreadCost[j]);
        if (balanced) share[j] = j / 2, spreadCost[j] = left.cost[j / 2 - 1] + right.cost[j - j / 2 - 1];
    }
    const auto spreadNodes = [&](std::uint32_t j) { return left.nodes[share[j] - 1] + right.nodes[j - share[j] - 1]; };
    const auto spreadDepth = [&](std::uint32_t j) {
        return std::max(left.depth[share[j] - 1], right.depth[j - share[j] - 1]);
    };

    const float innerCost = spreadCost[kWideNodeSlots] + area * costs.node;
    const float leafCost =
        mayBeLeaf ? area * static_cast<float>(count) * costs.item : std::numeric_limits<float>::max();
    const bool leaf = mayBeLeaf && (balanced || leafCost <= innerCost);
    forest.cost[0] = leaf ? leafCost : innerCost;
    forest.nodes[0] = leaf ? 0 : 1 + spreadNodes(kWideNodeSlots);
    forest.depth[0] = leaf ? 0 : 1 + spreadDepth(kWideNodeSlots);
    std::uint32_t choices = (leaf ? kLeafBit : 0U) | share[kWideNodeSlots] << choiceShift(kWideNodeSlots);
    for (std::uint32_t j = 2; j < kWideNodeSlots; ++j) {
        const bool spread = balanced ? !leaf : spreadCost[j] < forest.cost[j - 2];
        forest.cost[j - 1] = spread ? spreadCost[j] : forest.cost[j - 2];
        forest.nodes[j - 1] = spread ? spreadNodes(j) : forest.nodes[j - 2];
        forest.depth[j - 1] = spread ? spreadDepth(j) : forest.depth[j - 2];
        if (spread) choices |= share[j] << choiceShift(j);
    }
    for (int axis = 0; axis < 3; ++axis) node.lo[axis] = forest.box.lo[axis], node.hi[axis] = forest.box.hi[axis];
    node.choices = choices;
    node.wideNodes = forest.nodes[0];
    return forest;
}

TreeSummary summarise(const BinaryNode& root, const Forest& left, const Forest& right) {
    const std::uint32_t k = leftSlots(root.choices, kWideNodeSlots) - 1, rest = kWideNodeSlots - k - 2;
    return {1 + left.nodes[k] + right.nodes[rest], 1 + std::max(left.depth[k], right.depth[rest]), false};
}

void emitWideTree(const WideTarget& target) {
    Emitter(target).emit({0, static_cast<std::uint32_t>(target.items.size()), 0}, 0, 1, 0);
}

}  // namespace vkpt
