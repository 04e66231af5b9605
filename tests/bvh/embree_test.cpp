// The same hits as Embree, on generated meshes and on scene files.
#include "embree_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "bvh/build.h"
#include "gltf/import.h"
#include "scene/flatten.h"
#include "traverse.h"
#include "verify/inputs/rays.h"
#include "verify/inputs/soups.h"

namespace vkpt {
namespace {

/// World-space triangles of a scene with or without instances.
Triangles bakedTriangles(const SceneArrays& arrays) {
    if (arrays.instances.empty()) return arrays.triangles;
    Triangles baked;
    for (std::size_t i = 0; i < arrays.instances.size(); ++i) {
        const MeshRange& range = arrays.meshRanges[arrays.instanceMesh[i]];
        const auto toWorld = [&](const vec3& p) {
            const vec4* rows = arrays.instances[i].worldFromObject;
            return vec3(glm::dot(rows[0], vec4(p, 1)), glm::dot(rows[1], vec4(p, 1)), glm::dot(rows[2], vec4(p, 1)));
        };
        for (std::uint32_t t = range.firstTriangle; t < range.firstTriangle + range.triangleCount; ++t) {
            const TriangleRecord& triangle = arrays.triangles[t];
            addTriangle(baked, toWorld(triangle.v0), toWorld(triangle.v1), toWorld(triangle.v2));
        }
    }
    return baked;
}

/// Both sides see rays rounded to float. Rays through silhouettes and seams may be decided either way: their share is
/// bounded by `allowedShare`.
void expectAgreement(const SceneArrays& arrays, std::size_t rays, double allowedShare) {
    const Triangles world = bakedTriangles(arrays);
    const EmbreeScene embree(world);
    WideTraversal traversal(arrays);
    std::size_t hits = 0, differ = 0, total = 0;
    for (Ray ray : raysAt(world, rays, Aim::Inside)) {
        ray.origin = glm::dvec3(vec3(ray.origin));
        ray.direction = glm::dvec3(vec3(ray.direction));
        const double ours = traversal.closest(ray).t, theirs = embree.closest(ray);
        const bool agree =
            std::isinf(ours) || std::isinf(theirs) ? ours == theirs : std::abs(ours - theirs) <= 1e-3 * (ours + theirs);
        hits += std::isfinite(ours) ? 1U : 0U;
        differ += agree ? 0U : 1U;
        ++total;
    }
    EXPECT_GT(hits, total / 5);
    EXPECT_LE(static_cast<double>(differ), allowedShare * static_cast<double>(total));
}

TEST(BvhAgainstEmbree, SameHitsOnGeneratedMeshes) {
    for (const auto& [name, triangles] : {NamedTriangles{"sphere", sphere(120)},
                                          {"displaced grid", grid(150, 0.3F)},
                                          {"soup", soup(30000, 1, 0.05F)},
                                          {"slivers", slivers(2000)}}) {
        SCOPED_TRACE(name);
        SceneArrays arrays = sceneOf(triangles);
        buildBvh(arrays);
        // Half of a sliver's width is near what rounding a ray to float costs.
        expectAgreement(arrays, 20000, name == "slivers" ? 0.1 : 0.001);
    }
}

void buildAndCompare(SceneArrays arrays, std::size_t rays) {
    BvhStats stats;
    buildBvh(arrays, {}, &stats);
    EXPECT_LE(stats.depth, kMaxBvhDepth);
    expectAgreement(arrays, rays, 0.003);
}

/// Checks one file with all meshes that are placed several times shared, and if there are any, also baked.
void expectAgreementOnFile(const std::filesystem::path& file, std::size_t rays) {
    SCOPED_TRACE(file.string());
    const Scene scene = importGltf(file);
    SceneArrays shared = flatten(scene, {.instancing = true, .instancingThreshold = 1});
    if (!shared.instances.empty()) buildAndCompare(flatten(scene, {.instancing = false}), rays);
    buildAndCompare(std::move(shared), rays);
}

TEST(BvhAgainstEmbree, SameHitsOnBundledScenes) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(VKPT_SCENES)) {
        const auto file = entry.path() / "scene.gltf";
        if (!std::filesystem::exists(file)) continue;
        expectAgreementOnFile(file, 3000);
        ++files;
    }
    EXPECT_GT(files, 5U);
}

TEST(BvhAgainstEmbree, SameHitsOnHelmetAndTruck) {
    const std::filesystem::path models = std::filesystem::path(VKPT_ASSETS) / "models";
    for (const char* name : {"DamagedHelmet.glb", "CesiumMilkTruck.glb"}) {
        if (!std::filesystem::exists(models / name)) GTEST_SKIP() << (models / name) << " is absent";
        expectAgreementOnFile(models / name, 10000);
    }
}

}  // namespace
}  // namespace vkpt
