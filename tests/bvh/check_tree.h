// Walks a tree and checks every rule of wide_node.h on the way.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "bvh/bounds.h"
#include "bvh/wide_node.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct TreeCheck {
    std::size_t nodes = 0;
    std::uint32_t depth = 0;
    std::vector<std::uint32_t> items;  ///< in the order met
    std::vector<Box> itemBoxes;        ///< the leaf box around each
};

/// Checks the meta bytes, that children and items are contiguous in slot order, and empty slots; collects the items.
inline void checkNode(const SceneArrays& arrays, std::uint32_t index, std::uint32_t level, TreeCheck& check) {
    ASSERT_LT(index, arrays.nodes.size());
    ASSERT_LE(level, kMaxBvhDepth);
    const WideNode& node = arrays.nodes[index];
    ++check.nodes;
    check.depth = std::max(check.depth, level);
    std::uint32_t nextChild = node.childBase, nextItem = node.itemBase;
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        const std::uint32_t meta = wideMeta(node, s);
        const WideChild child = wideChild(node, s);
        EXPECT_EQ((wideInnerMask(node) >> s & 1U) != 0, child.kind == WideChildKind::Inner);
        if (child.kind == WideChildKind::Empty) {
            EXPECT_EQ(meta, 0U);
            EXPECT_EQ(wideByte(node.loX0, node.loX1, s), 255U);
            EXPECT_EQ(wideByte(node.hiX0, node.hiX1, s), 0U);
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) EXPECT_LE(child.box.lo[axis], child.box.hi[axis]);
        if (child.kind == WideChildKind::Inner) {
            EXPECT_EQ(meta, 1U << 5 | (24U + s));
            EXPECT_EQ(child.first, nextChild++);
            checkNode(arrays, child.first, level + 1, check);
        } else {
            EXPECT_TRUE(meta >> 5 == 1 || meta >> 5 == 3 || meta >> 5 == 7);
            EXPECT_EQ(child.first, nextItem);
            EXPECT_GE(child.count, 1U);
            EXPECT_LE(child.count, kWideNodeLeafItems);
            for (std::uint32_t i = 0; i < child.count; ++i) {
                check.items.push_back(nextItem++);
                check.itemBoxes.push_back(child.box);
            }
        }
    }
}

inline bool isFiniteTriangle(const TriangleRecord& t) {
    const vec3 largest = glm::max(glm::abs(t.v0), glm::max(glm::abs(t.v1), glm::abs(t.v2)));
    const float sum = t.v0.x + t.v0.y + t.v0.z + t.v1.x + t.v1.y + t.v1.z + t.v2.x + t.v2.y + t.v2.z;
    return sum - sum == 0 && std::max(largest.x, std::max(largest.y, largest.z)) <= kMaxCoordinate;
}

inline void expectContains(const Box& box, const vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.lo[axis], p[axis]);
        EXPECT_GE(box.hi[axis], p[axis]);
    }
}

/// The decoded boxes on the whole path to a triangle contain it, exactly.
inline void checkContainment(const SceneArrays& arrays, std::uint32_t index, std::vector<Box>& path) {
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        const WideChild child = wideChild(arrays.nodes[index], s);
        if (child.kind == WideChildKind::Empty) continue;
        path.push_back(child.box);
        if (child.kind == WideChildKind::Inner) {
            checkContainment(arrays, child.first, path);
        } else {
            for (std::uint32_t i = child.first; i < child.first + child.count; ++i) {
                const TriangleRecord& t = arrays.triangles[i];
                if (!isFiniteTriangle(t)) continue;
                for (const Box& box : path)
                    expectContains(box, t.v0), expectContains(box, t.v1), expectContains(box, t.v2);
            }
        }
        path.pop_back();
    }
}

/// Checks the tree of one mesh: every triangle of `range` is in exactly one leaf, and nothing else is.
inline TreeCheck checkMesh(const SceneArrays& arrays, std::uint32_t root, const MeshRange& range) {
    TreeCheck check;
    checkNode(arrays, root, 1, check);
    if (::testing::Test::HasFatalFailure()) return check;
    EXPECT_EQ(check.items.size(), range.triangleCount);
    std::sort(check.items.begin(), check.items.end());
    for (std::size_t i = 0; i < check.items.size(); ++i) EXPECT_EQ(check.items[i], range.firstTriangle + i);
    std::vector<Box> path;
    checkContainment(arrays, root, path);
    return check;
}

}  // namespace vkpt
