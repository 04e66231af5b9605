// Walking the tree finds what testing every triangle finds.
#include "traverse.h"

#include <gtest/gtest.h>

#include "bvh/build.h"
#include "verify/inputs/rays.h"

namespace vkpt {
namespace {

TEST(BvhTraversal, FindsTheHitsOfBruteForce) {
    for (const auto& [name, triangles] : allSets()) {
        SCOPED_TRACE(name);
        SceneArrays arrays = sceneOf(triangles);
        buildBvh(arrays);
        WideTraversal traversal(arrays);
        std::size_t hits = 0;
        for (const Ray& ray : raysAt(triangles, 1500)) {
            const Hit expected = bruteForce(arrays, ray), found = traversal.closest(ray);
            ASSERT_EQ(found.primitive, expected.primitive);
            ASSERT_EQ(found.t, expected.t);
            hits += found.any() ? 1U : 0U;
        }
        if (triangles.empty() || name == "point" || name == "line") continue;  // nothing has an area
        const bool few = triangles.size() < 10;
        EXPECT_GT(hits, few ? 0U : 100U) << "the rays miss too often to prove anything";
    }
}

TEST(BvhTraversal, OfCoincidentTrianglesTheLowestPrimitiveWins) {
    const Triangles triangles = duplicates(10, 30);
    SceneArrays arrays = sceneOf(triangles);
    buildBvh(arrays);
    WideTraversal traversal(arrays);
    std::size_t hits = 0;
    for (const Ray& ray : raysAt(triangles, 500)) {
        const Hit hit = traversal.closest(ray);
        if (!hit.any()) continue;
        EXPECT_LT(hit.primitive, 10U);
        ++hits;
    }
    EXPECT_GT(hits, 100U);
}

TEST(BvhTraversal, VisitsFewNodes) {
    const Triangles triangles = sphere(100);  // 40,000
    SceneArrays arrays = sceneOf(triangles);
    buildBvh(arrays);
    WideTraversal traversal(arrays);
    const auto rays = raysAt(triangles, 2000);
    for (const Ray& ray : rays) traversal.closest(ray);
    const double perRay = static_cast<double>(traversal.nodeVisits()) / static_cast<double>(rays.size());
    EXPECT_LT(perRay, 30) << "of " << arrays.nodes.size() << " nodes";
}

TEST(BvhTraversal, SlotOrderVisitsNearChildrenFirst) {
    // Walking far to near enters more nodes than walking in the order that the slots encode.
    const Triangles triangles = soup(20000, 1, 0.05F);
    SceneArrays arrays = sceneOf(triangles);
    buildBvh(arrays);
    WideTraversal inOrder(arrays), reversed(arrays, SlotOrder::Reversed);
    for (const Ray& ray : raysAt(triangles, 1500)) EXPECT_EQ(inOrder.closest(ray), reversed.closest(ray));
    EXPECT_LT(static_cast<double>(inOrder.nodeVisits()), 0.8 * static_cast<double>(reversed.nodeVisits()));
}

}  // namespace
}  // namespace vkpt
