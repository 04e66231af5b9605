#include "bvh/quality.h"

#include <algorithm>
#include <vector>

namespace vkpt {

namespace {

double halfAreaOf(const Box& box) {
    const glm::dvec3 d = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Depth and cost of the tree below one node.
struct TreeFigures {
    std::uint32_t depth = 1;
    double cost = 0;  ///< expected cost of a ray that meets the root's box
};

class Meter {
public:
    Meter(const SceneArrays& arrays, const BvhConfig& config) : arrays_(arrays), config_(config) {}

    TreeFigures mesh(std::uint32_t root) {
        return tree(root, [&](std::uint32_t) { return TreeFigures{0, config_.triangleCost}; });
    }

    TreeFigures top(std::uint32_t root) {
        const std::size_t before = nodes_;
        const TreeFigures figures = tree(root, [&](std::uint32_t instance) {
            const TreeFigures& placed = meshes_[arrays_.instanceMesh[instance]];
            return TreeFigures{placed.depth, config_.instanceCost + placed.cost};
        });
        topNodes_ = nodes_ - before;
        return figures;
    }

    /// Must come before top(): an instance costs what its mesh costs. Roots are found through the instances.
    void allMeshes() {
        meshes_.resize(arrays_.meshRanges.size());
        std::vector<bool> seen(meshes_.size());
        for (std::size_t i = 0; i < arrays_.instances.size(); ++i) {
            const std::uint32_t m = arrays_.instanceMesh[i];
            if (!seen[m]) meshes_[m] = mesh(arrays_.instances[i].rootNode);
            seen[m] = true;
        }
    }

    void fill(BvhStats& stats) const {
        stats.topNodes = topNodes_;
        stats.leaves = leaves_;
        stats.itemsPerLeaf = leaves_ != 0 ? static_cast<double>(items_) / static_cast<double>(leaves_) : 0;
        stats.childrenPerNode = nodes_ != 0 ? static_cast<double>(leaves_ + inner_) / static_cast<double>(nodes_) : 0;
    }

private:
    template <typename ItemFigures>
    TreeFigures tree(std::uint32_t root, const ItemFigures& itemFigures) {
        Box box;
        bool first = true;
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            const WideChild child = wideChild(arrays_.nodes[root], s);
            if (child.kind == WideChildKind::Empty) continue;
            box = first ? child.box : Box{glm::min(box.lo, child.box.lo), glm::max(box.hi, child.box.hi)};
            first = false;
        }
        const double area = halfAreaOf(box);
        TreeFigures figures = below(root, area, itemFigures);
        if (area > 0) figures.cost /= area;
        return figures;
    }

    /// Cost weighted by area.
    template <typename ItemFigures>
    TreeFigures below(std::uint32_t index, double area, const ItemFigures& itemFigures) {
        ++nodes_;
        TreeFigures figures{1, area * config_.nodeCost};
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            const WideChild child = wideChild(arrays_.nodes[index], s);
            const double childArea = halfAreaOf(child.box);
            if (child.kind == WideChildKind::Inner) {
                ++inner_;
                const TreeFigures sub = below(child.first, childArea, itemFigures);
                figures.cost += sub.cost;
                figures.depth = std::max(figures.depth, 1 + sub.depth);
            }
            if (child.kind == WideChildKind::Leaf) ++leaves_;
            for (std::uint32_t i = 0; child.kind == WideChildKind::Leaf && i < child.count; ++i) {
                const TreeFigures item = itemFigures(child.first + i);
                ++items_;
                figures.cost += childArea * item.cost;
                figures.depth = std::max(figures.depth, 1 + item.depth);
            }
        }
        return figures;
    }

    const SceneArrays& arrays_;
    const BvhConfig& config_;
    std::vector<TreeFigures> meshes_;
    std::size_t nodes_ = 0, topNodes_ = 0, inner_ = 0, leaves_ = 0, items_ = 0;
};

}  // namespace

BvhStats measureBvh(const SceneArrays& arrays, const BvhConfig& config) {
    Meter meter(arrays, config);
    TreeFigures figures;
    if (arrays.instances.empty()) {
        figures = meter.mesh(arrays.rootNode);
    } else {
        meter.allMeshes();
        figures = meter.top(arrays.rootNode);
    }
    BvhStats stats;
    meter.fill(stats);
    stats.nodes = arrays.nodes.size();
    stats.bytes = stats.nodes * sizeof(WideNode);
    stats.depth = figures.depth;
    stats.sahCost = figures.cost;
    if (!arrays.triangles.empty()) {
        stats.bytesPerTriangle = static_cast<double>(stats.bytes) / static_cast<double>(arrays.triangles.size());
    }
    return stats;
}

}  // namespace vkpt
