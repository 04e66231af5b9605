// The same hits as Embree, an independent builder and traversal.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "bvh/build.h"
#include "gltf/import.h"
#include "rays.h"
#include "scene/flatten.h"
#include "soups.h"
#include "traverse.h"

namespace vkpt {
namespace {

struct EmbreeRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

/// Embree over world-space triangles.
class EmbreeScene {
public:
    explicit EmbreeScene(const Triangles& triangles)
        : device_(rtcNewDevice("threads=2")), scene_(rtcNewScene(device_.get())) {
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
        const RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t n = triangles.size();
        auto* corners = static_cast<float*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * n));
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), n));
        for (std::size_t i = 0; i < n; ++i) {
            for (const vec3& v : {triangles[i].v0, triangles[i].v1, triangles[i].v2}) {
                for (int axis = 0; axis < 3; ++axis) *corners++ = v[axis];
            }
        }
        for (std::size_t i = 0; i < 3 * n; ++i) indices[i] = static_cast<std::uint32_t>(i);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_.get());
    }

    /// Distance of the closest hit in units of the direction, infinite where there is none.
    [[nodiscard]] float closest(const Ray& ray) const {
        RTCRayHit query{};
        query.ray.org_x = static_cast<float>(ray.origin.x);
        query.ray.org_y = static_cast<float>(ray.origin.y);
        query.ray.org_z = static_cast<float>(ray.origin.z);
        query.ray.dir_x = static_cast<float>(ray.direction.x);
        query.ray.dir_y = static_cast<float>(ray.direction.y);
        query.ray.dir_z = static_cast<float>(ray.direction.z);
        query.ray.tfar = INFINITY;
        query.ray.mask = ~0U;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_.get(), &context, &query);
        return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : query.ray.tfar;
    }

private:
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, EmbreeRelease> device_;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease> scene_;
};

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

}  // namespace
}  // namespace vkpt
