// Embree as an independent builder and traversal.
#pragma once
#include <embree3/rtcore.h>

#include <cmath>
#include <memory>
#include <type_traits>

#include "traverse.h"
#include "verify/inputs/soups.h"

namespace vkpt {

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

}  // namespace vkpt
