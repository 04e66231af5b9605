// The nodes are what wide_node.h says, whatever the triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "bvh/build.h"
#include "check_tree.h"
#include "verify/inputs/soups.h"

namespace vkpt {
namespace {

TEST(BvhStructure, HoldsEveryTriangleOnceInBoxesThatContainIt) {
    for (auto& [name, triangles] : allSets()) {
        SCOPED_TRACE(name);
        SceneArrays arrays = sceneOf(triangles);
        BvhStats stats;
        buildBvh(arrays, {}, &stats);
        const TreeCheck check = checkMesh(arrays, arrays.rootNode, arrays.meshRanges[0]);
        EXPECT_EQ(check.nodes, arrays.nodes.size());
        EXPECT_EQ(check.depth, stats.depth);
        EXPECT_EQ(check.depth, arrays.bvhDepth);
        EXPECT_LE(check.depth, kMaxMeshDepth);
    }
}

TEST(BvhStructure, ReordersTrianglesWithoutChangingThem) {
    const Triangles before = soup(5000, 1, 0.1F);
    SceneArrays arrays = sceneOf(before);
    buildBvh(arrays);
    ASSERT_EQ(arrays.triangles.size(), before.size());
    std::vector<bool> seen(before.size());
    for (const TriangleRecord& t : arrays.triangles) {
        ASSERT_LT(t.primitive, before.size());
        EXPECT_FALSE(seen[t.primitive]);
        seen[t.primitive] = true;
        EXPECT_EQ(std::memcmp(&t, &before[t.primitive], sizeof t), 0);
    }
}

TEST(BvhStructure, EmptySceneIsOneNodeWithoutChildren) {
    for (const bool withRange : {true, false}) {
        SceneArrays arrays;
        if (withRange) arrays.meshRanges = {{0, 0}};
        BvhStats stats;
        buildBvh(arrays, {}, &stats);
        ASSERT_EQ(arrays.nodes.size(), 1U);
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            EXPECT_EQ(wideChild(arrays.nodes[0], s).kind, WideChildKind::Empty);
        }
        EXPECT_EQ(arrays.rootNode, 0U);
        EXPECT_EQ(stats.nodes, 1U);
        EXPECT_EQ(stats.leaves, 0U);
    }
}

TEST(BvhStructure, PointsLightsAtTheirTrianglesNewPlaces) {
    SceneArrays arrays = sceneOf(soup(1000, 1, 0.1F));
    arrays.lights.push_back({});  // not a triangle's: stays as it is
    arrays.lights[0].index = 12345;
    for (std::size_t i = 0; i < arrays.triangles.size(); i += 7) {
        TriangleRecord& t = arrays.triangles[i];
        t.light = static_cast<std::uint32_t>(arrays.lights.size());
        LightRecord light{};
        light.a = t.v0, light.b = t.v1, light.c = t.v2;
        light.index = static_cast<std::uint32_t>(i);
        arrays.lights.push_back(light);
    }
    buildBvh(arrays);
    EXPECT_EQ(arrays.lights[0].index, 12345U);
    std::size_t moved = 0;
    for (std::size_t l = 1; l < arrays.lights.size(); ++l) {
        const LightRecord& light = arrays.lights[l];
        const TriangleRecord& t = arrays.triangles.at(light.index);
        EXPECT_EQ(t.light, l);
        EXPECT_EQ(t.v0, light.a);
        moved += light.index != (l - 1) * 7 ? 1U : 0U;
    }
    EXPECT_GT(moved, 0U);
}

TEST(BvhStructure, KeepsTrianglesThatAreNotFiniteOutOfTheOthersWay) {
    Triangles triangles = soup(500, 1, 0.1F);
    const float bad[] = {NAN, INFINITY, -INFINITY, 3e38F};
    for (std::size_t i = 0; i < 4; ++i) triangles[i * 100].v1.y = bad[i];
    SceneArrays arrays = sceneOf(triangles);
    BvhStats stats;
    buildBvh(arrays, {}, &stats);
    const TreeCheck check = checkMesh(arrays, 0, arrays.meshRanges[0]);
    EXPECT_EQ(check.nodes, arrays.nodes.size());
    EXPECT_TRUE(std::isfinite(stats.sahCost));
    for (const WideNode& node : arrays.nodes) {
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            const Box box = wideBox(node, s);
            EXPECT_LE(std::abs(box.hi.y) + std::abs(box.lo.y), 10);
        }
    }
}

TEST(BvhStructure, TakesCoordinatesUpToItsLimit) {
    SceneArrays arrays = sceneOf(soup(500, 4e36F, 0.5F));
    buildBvh(arrays);
    EXPECT_EQ(checkMesh(arrays, 0, arrays.meshRanges[0]).nodes, arrays.nodes.size());
}

TEST(BvhStructure, KeepsToTheDepthItIsGiven) {
    // 8^4 triangles fill four levels completely: only a balanced tree fits.
    for (const auto& [name, triangles] :
         {NamedTriangles{"soup", soup(4096, 1, 0.1F)}, {"nested", nested(400, 0.8F)}, {"copies", duplicates(8, 512)}}) {
        SCOPED_TRACE(name);
        SceneArrays arrays = sceneOf(triangles);
        BvhStats stats;
        buildBvh(arrays, {.maxMeshDepth = 4}, &stats);
        EXPECT_LE(stats.depth, 4U);
        const TreeCheck check = checkMesh(arrays, 0, arrays.meshRanges[0]);
        EXPECT_EQ(check.nodes, arrays.nodes.size());
        EXPECT_EQ(check.depth, stats.depth);
    }
    SceneArrays arrays = sceneOf(nested(60, 0.5F));
    SceneArrays again = arrays;
    BvhStats free, bound;
    buildBvh(arrays, {}, &free);
    buildBvh(again, {.maxMeshDepth = 3}, &bound);
    ASSERT_GT(free.depth, 3U) << "the set no longer makes a deep tree";
    EXPECT_EQ(free.balancedTrees, 0U);
    EXPECT_EQ(bound.balancedTrees, 1U);
    EXPECT_LE(bound.depth, 3U);
}

TEST(BvhStructure, StaysShallowWhereAllAreasVanish) {
    Triangles line, copies = duplicates(1, 4096);
    for (int i = 0; i < 4096; ++i) {
        const auto x = static_cast<float>(i);
        addTriangle(line, vec3(x, 0, 0), vec3(x + 1, 0, 0), vec3(x + 2, 0, 0));
    }
    for (const Triangles& triangles : {line, copies}) {
        SceneArrays arrays = sceneOf(triangles);
        BvhStats stats;
        buildBvh(arrays, {}, &stats);
        EXPECT_LE(stats.depth, 6U);  // 4 where every node is full
        EXPECT_EQ(stats.balancedTrees, 0U);
    }
}

TEST(BvhStructure, FiguresDescribeTheTree) {
    SceneArrays arrays = sceneOf(grid(100, 0.2F));
    BvhStats stats;
    buildBvh(arrays, {}, &stats);
    EXPECT_EQ(stats.nodes, arrays.nodes.size());
    EXPECT_EQ(stats.bytes, arrays.nodes.size() * 80);
    EXPECT_DOUBLE_EQ(stats.bytesPerTriangle, static_cast<double>(stats.bytes) / 20000.0);
    EXPECT_DOUBLE_EQ(stats.itemsPerLeaf * static_cast<double>(stats.leaves), 20000.0);
    EXPECT_LE(stats.itemsPerLeaf, 3);
    EXPECT_GT(stats.childrenPerNode, 6);
    EXPECT_LT(stats.bytesPerTriangle, 12);
    EXPECT_GT(stats.seconds, 0);
    EXPECT_EQ(stats.topNodes, 0U);

    // One node over one leaf that fills it: the node's cost and three triangles.
    SceneArrays single = sceneOf(duplicates(1, 3));
    buildBvh(single, {.nodeCost = 2, .triangleCost = 0.5F}, &stats);
    EXPECT_NEAR(stats.sahCost, 2 + 3 * 0.5, 1e-6);
}

}  // namespace
}  // namespace vkpt
