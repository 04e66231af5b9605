// Two levels: a tree over placed meshes, each with its own tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "bvh/build.h"
#include "bvh/item_refs.h"
#include "check_tree.h"
#include "traverse.h"
#include "verify/inputs/rays.h"
#include "verify/inputs/soups.h"

namespace vkpt {
namespace {

InstanceRecord placed(const glm::dmat4& worldFromObject, std::uint32_t object) {
    const glm::dmat4 forward = glm::transpose(worldFromObject), back = glm::transpose(glm::inverse(worldFromObject));
    InstanceRecord record{};
    for (int row = 0; row < 3; ++row) {
        record.worldFromObject[row] = vec4(forward[row]);
        record.objectFromWorld[row] = vec4(back[row]);
    }
    record.object = object;
    return record;
}

void addMesh(SceneArrays& arrays, const Triangles& triangles) {
    arrays.meshRanges.push_back(
        {static_cast<std::uint32_t>(arrays.triangles.size()), static_cast<std::uint32_t>(triangles.size())});
    for (TriangleRecord t : triangles) {
        t.primitive = static_cast<std::uint32_t>(arrays.triangles.size());
        arrays.triangles.push_back(t);
    }
}

void place(SceneArrays& arrays, std::uint32_t mesh, const glm::dmat4& worldFromObject) {
    arrays.instances.push_back(placed(worldFromObject, static_cast<std::uint32_t>(arrays.instances.size())));
    arrays.instanceMesh.push_back(mesh);
}

/// Baked ground, three shared meshes (one of them empty) and `n` places, rotated, stretched and overlapping.
SceneArrays forest(std::size_t n) {
    SceneArrays arrays;
    addMesh(arrays, grid(12, 0.3F));
    addMesh(arrays, sphere(8));
    addMesh(arrays, {});
    addMesh(arrays, soup(200, 1, 0.3F));
    place(arrays, 0, glm::dmat4(1));
    Random random(17);
    for (std::size_t i = 0; i < n; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), glm::dvec3(random.vec()));
        m = glm::rotate(m, 3.0 * random(), glm::normalize(glm::dvec3(random.vec())));
        m = glm::scale(m, glm::dvec3(random.vec()) * 0.1 + 0.15);
        place(arrays, 1 + static_cast<std::uint32_t>(i % 3), m);
    }
    return arrays;
}

TEST(BvhInstances, EveryPlacedMeshIsInOneLeafAndPointsAtItsTree) {
    const SceneArrays before = forest(100);
    SceneArrays arrays = before;
    BvhStats stats;
    buildBvh(arrays, {}, &stats);
    ASSERT_EQ(arrays.instances.size(), before.instances.size());

    TreeCheck top;
    checkNode(arrays, arrays.rootNode, 1, top);
    EXPECT_EQ(top.nodes, stats.topNodes);
    std::sort(top.items.begin(), top.items.end());
    std::size_t placedMeshes = 0;
    for (const std::uint32_t m : before.instanceMesh) placedMeshes += before.meshRanges[m].triangleCount != 0 ? 1U : 0U;
    ASSERT_EQ(top.items.size(), placedMeshes);
    for (std::size_t i = 0; i < top.items.size(); ++i) EXPECT_EQ(top.items[i], i);

    std::vector<bool> seen(before.instances.size());
    std::uint32_t meshDepth = 0;
    for (std::size_t i = 0; i < arrays.instances.size(); ++i) {
        const InstanceRecord& instance = arrays.instances[i];
        EXPECT_FALSE(seen[instance.object]);
        seen[instance.object] = true;
        EXPECT_EQ(arrays.instanceMesh[i], before.instanceMesh[instance.object]);
        EXPECT_EQ(instance.worldFromObject[0], before.instances[instance.object].worldFromObject[0]);
        const MeshRange& range = arrays.meshRanges[arrays.instanceMesh[i]];
        EXPECT_EQ(range.triangleCount == 0, i >= placedMeshes) << "instances of empty meshes come last";
        meshDepth = std::max(meshDepth, checkMesh(arrays, instance.rootNode, range).depth);
    }
    EXPECT_EQ(stats.depth, top.depth + meshDepth);
    EXPECT_EQ(arrays.bvhDepth, stats.depth);
    EXPECT_LE(stats.depth, kMaxBvhDepth);
}

TEST(BvhInstances, TraversalFindsTheHitsOfBruteForce) {
    for (const std::size_t n : {std::size_t{1}, std::size_t{7}, std::size_t{120}}) {
        SceneArrays arrays = forest(n);
        const Triangles targets = soup(200, 1, 0.3F);
        buildBvh(arrays);
        WideTraversal traversal(arrays);
        std::size_t hits = 0, placedHits = 0;
        for (const Ray& ray : raysAt(targets, 800)) {
            const Hit expected = bruteForce(arrays, ray);
            ASSERT_EQ(traversal.closest(ray), expected);
            hits += expected.any() ? 1U : 0U;
            placedHits += expected.any() && arrays.instanceMesh[expected.instance] != 0 ? 1U : 0U;
        }
        EXPECT_GT(hits, 50U);
        EXPECT_GT(placedHits, 10U);
    }
}

TEST(BvhInstances, BoxesContainTheTrianglesWherePlaced) {
    SceneArrays arrays = forest(60);
    buildBvh(arrays);
    TreeCheck top;
    checkNode(arrays, arrays.rootNode, 1, top);
    for (std::size_t k = 0; k < top.items.size(); ++k) {
        const std::uint32_t i = top.items[k];
        const MeshRange& range = arrays.meshRanges[arrays.instanceMesh[i]];
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            for (int row = 0; row < 3; ++row) {
                const glm::dvec4 m(arrays.instances[i].worldFromObject[row]);
                const double x = glm::dot(m, glm::dvec4(glm::dvec3(arrays.triangles[t].v2), 1));
                ASSERT_LE(top.itemBoxes[k].lo[row], x);
                ASSERT_GE(top.itemBoxes[k].hi[row], x);
            }
        }
    }
}

TEST(BvhInstances, WorldBoxAllowsForTheRoundingOfBothMatrices) {
    // Points that a float transformation carries into the object's box lie in its world box, though both matrices are
    // rounded and no longer inverse to each other.
    Random random(23);
    const Box object{{-1, -0.5F, 2}, {1, 0.5F, 2.5F}};
    std::size_t inside = 0;
    for (int round = 0; round < 300; ++round) {
        glm::dmat4 m = glm::translate(glm::dmat4(1), 100.0 * glm::dvec3(random.vec()));
        m = glm::rotate(m, 3.0 * random(), glm::normalize(glm::dvec3(random.vec())));
        m = glm::scale(m, glm::dvec3(0.7));
        const InstanceRecord instance = placed(m, 0);
        const Bounds world = placedBounds(instance, {&object, 1});
        for (int k = 0; k < 64; ++k) {
            glm::dvec3 p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = (k >> axis & 1) != 0 ? object.hi[axis] : object.lo[axis];
            const vec3 x = vec3(m * glm::dvec4(p, 1)) + 1e-5F * random.vec();
            bool met = true, contained = true;
            for (int axis = 0; axis < 3; ++axis) {
                const vec4& row = instance.objectFromWorld[axis];
                const float q = row.x * x.x + row.y * x.y + row.z * x.z + row.w;
                met = met && q >= object.lo[axis] && q <= object.hi[axis];
                contained = contained && x[axis] >= world.lo[axis] && x[axis] <= world.hi[axis];
            }
            EXPECT_TRUE(contained || !met);
            inside += met ? 1U : 0U;
        }
    }
    EXPECT_GT(inside, 1000U);
}

TEST(BvhInstances, KeepsTheTopLevelWithinItsDepth) {
    SceneArrays arrays;
    addMesh(arrays, {});
    addMesh(arrays, sphere(2));
    place(arrays, 0, glm::dmat4(1));
    for (int i = 0; i < 60; ++i) {  // each a third of the one before: the SAH alone would go deep
        const double s = std::pow(1.0 / 3.0, i % 30);
        place(arrays, 1, glm::scale(glm::translate(glm::dmat4(1), glm::dvec3(2 * s, 0, 0)), glm::dvec3(s)));
    }
    SceneArrays shallow = arrays;
    BvhStats stats;
    buildBvh(arrays, {}, &stats);
    EXPECT_LE(stats.depth, kMaxBvhDepth);
    buildBvh(shallow, {.maxTopDepth = 2}, &stats);
    TreeCheck top;
    checkNode(shallow, 0, 1, top);
    EXPECT_LE(top.depth, 2U);
    EXPECT_EQ(top.items.size(), 60U);
}

TEST(BvhInstances, OnlyEmptyMeshesMakeAnEmptyTopLevel) {
    SceneArrays arrays;
    addMesh(arrays, {});
    place(arrays, 0, glm::dmat4(1));
    buildBvh(arrays);
    EXPECT_EQ(arrays.nodes.size(), 2U);
    EXPECT_FALSE(WideTraversal(arrays).closest({}).any());
}

}  // namespace
}  // namespace vkpt
