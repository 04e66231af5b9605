// The tree is a function of the scene alone.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstring>

#include "bvh/build.h"
#include "verify/inputs/soups.h"

namespace vkpt {
namespace {

SceneArrays builtWith(const Triangles& triangles, int threads) {
    SceneArrays arrays = sceneOf(triangles);
    // Also where the machine has fewer cores.
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena(threads).execute([&] { buildBvh(arrays); });
    return arrays;
}

void expectSameBits(const SceneArrays& a, const SceneArrays& b) {
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(WideNode)), 0);
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    EXPECT_EQ(std::memcmp(a.triangles.data(), b.triangles.data(), a.triangles.size() * sizeof(TriangleRecord)), 0);
}

TEST(BvhDeterminism, DoesNotDependOnTheNumberOfThreads) {
    // Large enough for chunked binning and partition, with zeros of both signs among the coordinates.
    Triangles triangles = soup(150000, 1, 0.02F);
    for (std::size_t i = 0; i < triangles.size(); i += 3) triangles[i].v0.x = i % 2 == 0 ? 0.0F : -0.0F;
    const SceneArrays one = builtWith(triangles, 1);
    for (const int threads : {2, 3, 8}) {
        SCOPED_TRACE(threads);
        expectSameBits(one, builtWith(triangles, threads));
    }
}

TEST(BvhDeterminism, RepeatsItself) {
    const Triangles triangles = duplicates(500, 8);
    const SceneArrays first = builtWith(triangles, 4);
    for (int round = 0; round < 5; ++round) expectSameBits(first, builtWith(triangles, 4));
}

}  // namespace
}  // namespace vkpt
