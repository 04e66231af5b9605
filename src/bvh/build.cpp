#include "bvh/build.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <memory>
#include <numeric>

#include "bvh/binary_tree.h"
#include "bvh/collapse.h"
#include "bvh/item_refs.h"
#include "bvh/quality.h"

namespace vkpt {

namespace {

/// Binary trees of several sets of items in one pair of arrays.
class Forests {
public:
    explicit Forests(std::vector<std::uint32_t> counts) : counts_(std::move(counts)), first_(counts_.size()) {
        std::exclusive_scan(counts_.begin(), counts_.end(), first_.begin(), std::size_t{0});
        total_ = counts_.empty() ? 0 : first_.back() + counts_.back();
        // Left uninitialised: the threads that fill them touch the pages first.
        items_ = std::make_unique_for_overwrite<ItemRef[]>(total_);
        nodes_ = std::make_unique_for_overwrite<BinaryNode[]>(total_);
        summaries_.resize(counts_.size());
    }

    [[nodiscard]] std::span<ItemRef> items(std::size_t tree) { return {items_.get() + first_[tree], counts_[tree]}; }
    [[nodiscard]] std::span<BinaryNode> nodes(std::size_t tree) { return {nodes_.get() + first_[tree], counts_[tree]}; }
    [[nodiscard]] const TreeSummary& summary(std::size_t tree) const { return summaries_[tree]; }
    [[nodiscard]] std::size_t trees() const { return counts_.size(); }
    [[nodiscard]] std::size_t items() const { return total_; }
    [[nodiscard]] std::size_t bytes() const { return total_ * (sizeof(ItemRef) + sizeof(BinaryNode)); }

    void build(std::size_t tree, const TreeCosts& costs) {
        if (counts_[tree] > 1) summaries_[tree] = buildBinaryTree(items(tree), nodes(tree), costs);
    }

    /// Writes the wide nodes of a tree at nodes[firstNode] and its order of items, which are to lie at firstItem.
    void emit(std::size_t tree, std::span<WideNode> wide, std::uint32_t firstNode, std::span<std::uint32_t> order,
              std::uint32_t firstItem) {
        emitWideTree({items(tree), nodes(tree), wide.subspan(firstNode, summaries_[tree].wideNodes), order, firstNode,
                      firstItem});
    }

    /// Boxes of the binary subtrees `levels` below the root: a tighter hull than the root's own box.
    [[nodiscard]] std::vector<Box> hull(std::size_t tree, int levels) {
        std::vector<Box> boxes;
        if (counts_[tree] != 0) collect(tree, {0, counts_[tree], 0}, levels, boxes);
        return boxes;
    }

private:
    void collect(std::size_t tree, const Subtree& at, int levels, std::vector<Box>& boxes) {
        if (at.count() == 1) {
            const Bounds box = items(tree)[at.begin].box();
            boxes.push_back({{box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]}});
            return;
        }
        const BinaryNode& node = nodes(tree)[at.node];
        if (levels == 0) {
            boxes.push_back({{node.lo[0], node.lo[1], node.lo[2]}, {node.hi[0], node.hi[1], node.hi[2]}});
            return;
        }
        collect(tree, at.left(node.split), levels - 1, boxes);
        collect(tree, at.right(node.split), levels - 1, boxes);
    }

    std::vector<std::uint32_t> counts_;
    std::vector<std::size_t> first_;
    std::size_t total_ = 0;
    std::unique_ptr<ItemRef[]> items_;
    std::unique_ptr<BinaryNode[]> nodes_;
    std::vector<TreeSummary> summaries_;
};

/// target[i] = source[order[i]] within [first, first + order.size()); the rest stays.
template <typename T>
void permute(std::vector<T>& values, std::size_t first, std::span<const std::uint32_t> order) {
    const auto source = std::make_unique_for_overwrite<T[]>(order.size());
    const tbb::blocked_range<std::size_t> all(0, order.size(), 4096);
    tbb::parallel_for(all, [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) source[i] = values[first + order[i]];
    });
    tbb::parallel_for(all, [&](const auto& range) {
        std::copy(source.get() + range.begin(), source.get() + range.end(),
                  values.begin() + static_cast<std::ptrdiff_t>(first + range.begin()));
    });
}

class SceneBuilder {
public:
    SceneBuilder(SceneArrays& arrays, const BvhConfig& config) : arrays_(arrays), config_(config) {}

    void run(BvhStats* stats) {
        if (arrays_.meshRanges.empty()) arrays_.meshRanges.emplace_back();
        Forests meshes = buildMeshes();
        Forests top = buildTop(meshes);
        if (stats != nullptr) noteMemory(meshes, top, *stats);
        const std::vector<std::uint32_t> roots = layOut(meshes, top);
        std::vector<std::uint32_t> order(arrays_.triangles.size());
        emitMeshes(meshes, roots, order);
        emitTop(top, roots);
        meshes = Forests({});
        for (const MeshRange& range : arrays_.meshRanges) {
            permute(arrays_.triangles, range.firstTriangle,
                    std::span(order).subspan(range.firstTriangle, range.triangleCount));
        }
        remapLights();
    }

private:
    Forests buildMeshes() {
        std::vector<std::uint32_t> counts;
        for (const MeshRange& range : arrays_.meshRanges) {
            assert(std::size_t{range.firstTriangle} + range.triangleCount <= arrays_.triangles.size());
            counts.push_back(range.triangleCount);
        }
        Forests meshes(std::move(counts));
        const TreeCosts costs{config_.nodeCost, config_.triangleCost, std::min(config_.maxMeshDepth, kMaxMeshDepth)};
        tbb::parallel_for(std::size_t{0}, meshes.trees(), [&](std::size_t m) {
            const MeshRange& range = arrays_.meshRanges[m];
            makeTriangleRefs(std::span(arrays_.triangles).subspan(range.firstTriangle, range.triangleCount),
                             meshes.items(m));
            meshes.build(m, costs);
        });
        return meshes;
    }

    /// The tree over instances of meshes that have triangles; no tree without instances.
    Forests buildTop(Forests& meshes) {
        if (arrays_.instances.empty()) return Forests({});
        assert(arrays_.instanceMesh.size() == arrays_.instances.size());
        std::vector<std::vector<Box>> hulls(meshes.trees());
        for (std::size_t m = 0; m < hulls.size(); ++m) hulls[m] = meshes.hull(m, 4);
        std::vector<ItemRef> refs;
        for (std::uint32_t i = 0; i < arrays_.instances.size(); ++i) {
            const std::vector<Box>& hull = hulls[arrays_.instanceMesh[i]];
            if (!hull.empty()) refs.emplace_back(placedBounds(arrays_.instances[i], hull), i);
        }
        Forests top({static_cast<std::uint32_t>(refs.size())});
        std::copy(refs.begin(), refs.end(), top.items(0).begin());
        top.build(0, {config_.nodeCost, config_.instanceCost, std::min(config_.maxTopDepth, kMaxTopDepth)});
        return top;
    }

    static void noteMemory(const Forests& meshes, const Forests& top, BvhStats& stats) {
        for (std::size_t m = 0; m < meshes.trees(); ++m) {
            stats.balancedTrees += meshes.summary(m).balanced ? 1U : 0U;
        }
        if (top.trees() != 0 && top.summary(0).balanced) ++stats.balancedTrees;
        const std::size_t triangles = meshes.items(), order = triangles * sizeof(std::uint32_t);
        stats.temporaryBytes =
            std::max(meshes.bytes() + top.bytes() + order, order + triangles * sizeof(TriangleRecord));
    }

    /// Sizes arrays.nodes and notes their depth: the top level first, then mesh after mesh. Returns each mesh's root.
    std::vector<std::uint32_t> layOut(const Forests& meshes, const Forests& top) {
        std::uint32_t next = top.trees() != 0 ? top.summary(0).wideNodes : 0;
        std::uint32_t meshDepth = 0;
        std::vector<std::uint32_t> roots;
        for (std::size_t m = 0; m < meshes.trees(); ++m) {
            roots.push_back(next);
            meshDepth = std::max(meshDepth, meshes.summary(m).depth);
            next += meshes.summary(m).wideNodes;
        }
        arrays_.nodes.resize(next);
        arrays_.rootNode = 0;
        arrays_.bvhDepth = meshDepth + (top.trees() != 0 ? top.summary(0).depth : 0);
        return roots;
    }

    void emitMeshes(Forests& meshes, std::span<const std::uint32_t> roots, std::span<std::uint32_t> order) {
        tbb::parallel_for(std::size_t{0}, meshes.trees(), [&](std::size_t m) {
            const MeshRange& range = arrays_.meshRanges[m];
            meshes.emit(m, arrays_.nodes, roots[m], order.subspan(range.firstTriangle, range.triangleCount),
                        range.firstTriangle);
        });
    }

    void emitTop(Forests& top, std::span<const std::uint32_t> roots) {
        if (top.trees() == 0) return;
        std::vector<std::uint32_t> order(top.items(0).size());
        top.emit(0, arrays_.nodes, 0, order, 0);
        std::vector<bool> placed(arrays_.instances.size());
        for (const std::uint32_t i : order) placed[i] = true;
        for (std::uint32_t i = 0; i < placed.size(); ++i) {
            if (!placed[i]) order.push_back(i);
        }
        permute(arrays_.instances, 0, order);
        permute(arrays_.instanceMesh, 0, order);
        for (std::size_t i = 0; i < order.size(); ++i) arrays_.instances[i].rootNode = roots[arrays_.instanceMesh[i]];
    }

    void remapLights() {
        for (std::size_t slot = 0; slot < arrays_.triangles.size(); ++slot) {
            const std::uint32_t light = arrays_.triangles[slot].light;
            if (light != kNone) arrays_.lights[light].index = static_cast<std::uint32_t>(slot);
        }
    }

    SceneArrays& arrays_;
    const BvhConfig& config_;
};

}  // namespace

void buildBvh(SceneArrays& arrays, const BvhConfig& config, BvhStats* stats) {
    const auto start = std::chrono::steady_clock::now();
    BvhStats own;
    SceneBuilder(arrays, config).run(&own);
    if (stats == nullptr) return;
    *stats = measureBvh(arrays, config);
    stats->temporaryBytes = own.temporaryBytes;
    stats->balancedTrees = own.balancedTrees;
    stats->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace vkpt
