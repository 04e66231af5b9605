#include "bvh/item_refs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace vkpt {

namespace {

Float4 toFloat4(const vec3& v) { return Float4{v.x, v.y, v.z, 0}; }

bool isInRange(const vec3& v) {
    // Written so that NaN is out of range.
    return std::abs(v.x) <= kMaxCoordinate && std::abs(v.y) <= kMaxCoordinate && std::abs(v.z) <= kMaxCoordinate;
}

float clampCoordinate(float x) { return std::isnan(x) ? 0.0F : std::clamp(x, -kMaxCoordinate, kMaxCoordinate); }

Bounds triangleBounds(const TriangleRecord& t) {
    Bounds box;
    if (isInRange(t.v0) && isInRange(t.v1) && isInRange(t.v2)) {
        box.grow(toFloat4(t.v0));
        box.grow(toFloat4(t.v1));
        box.grow(toFloat4(t.v2));
    } else {
        box.grow(isInRange(t.v0) ? toFloat4(t.v0) : Float4{});
    }
    return box;
}

/// Bound of the error, in the world, of points no larger than `largest` taken to object space in float arithmetic by
/// matrices of rounded entries: a few units in the last place of each term there, carried back.
glm::dvec3 placementError(const InstanceRecord& instance, const glm::dvec3& largest) {
    constexpr double kRounding = 1.0 / (1 << 20);
    glm::dvec3 inObject, inWorld;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row = glm::abs(glm::dvec4(instance.objectFromWorld[axis]));
        inObject[axis] = kRounding * (glm::dot(glm::dvec3(row), largest) + row.w);
    }
    for (int axis = 0; axis < 3; ++axis) {
        inWorld[axis] = glm::dot(glm::abs(glm::dvec3(instance.worldFromObject[axis])), inObject);
    }
    return inWorld;
}

}  // namespace

void makeTriangleRefs(std::span<const TriangleRecord> triangles, std::span<ItemRef> refs) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            refs[i] = ItemRef(triangleBounds(triangles[i]), static_cast<std::uint32_t>(i));
        }
    });
}

Bounds placedBounds(const InstanceRecord& instance, std::span<const Box> boxes) {
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const Box& box : boxes) {
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec4 row(instance.worldFromObject[axis]);
            const glm::dvec3 p = glm::dvec3(row) * glm::dvec3(box.lo), q = glm::dvec3(row) * glm::dvec3(box.hi);
            const glm::dvec3 least = glm::min(p, q), most = glm::max(p, q);
            lo[axis] = std::min(lo[axis], row.w + least.x + least.y + least.z);
            hi[axis] = std::max(hi[axis], row.w + most.x + most.y + most.z);
        }
    }
    const glm::dvec3 pad = placementError(instance, glm::max(glm::abs(lo), glm::abs(hi)));
    Bounds world;
    for (int axis = 0; axis < 3; ++axis) {
        world.lo[axis] = clampCoordinate(static_cast<float>(lo[axis] - pad[axis]));
        world.hi[axis] = clampCoordinate(static_cast<float>(hi[axis] + pad[axis]));
    }
    world.lo[3] = world.hi[3] = 0;
    return world;
}

}  // namespace vkpt
