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

}  // namespace

void makeTriangleRefs(std::span<const TriangleRecord> triangles, std::span<ItemRef> refs) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, triangles.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            refs[i] = ItemRef(triangleBounds(triangles[i]), static_cast<std::uint32_t>(i));
        }
    });
}

Bounds placedBounds(const InstanceRecord& instance, std::span<const Box> boxes) {
    // Rounding of the transformed origin and direction is a few units in the last place of the largest term.
    constexpr double kRounding = 1.0 / (1 << 20);
    Bounds world;
    for (int axis = 0; axis < 3; ++axis) {
        const vec4 row = instance.worldFromObject[axis];
        double lo = 1e300, hi = -1e300, magnitude = 0;
        for (const Box& box : boxes) {
            double boxLo = row.w, boxHi = row.w, size = std::abs(row.w);
            for (int a = 0; a < 3; ++a) {
                const double p = double{row[a]} * box.lo[a], q = double{row[a]} * box.hi[a];
                boxLo += std::min(p, q);
                boxHi += std::max(p, q);
                size += std::max(std::abs(p), std::abs(q));
            }
            lo = std::min(lo, boxLo);
            hi = std::max(hi, boxHi);
            magnitude = std::max(magnitude, size);
        }
        const double pad = magnitude * kRounding;
        world.lo[axis] = clampCoordinate(static_cast<float>(lo - pad));
        world.hi[axis] = clampCoordinate(static_cast<float>(hi + pad));
    }
    world.lo[3] = world.hi[3] = 0;
    return world;
}

}  // namespace vkpt
