#include "verify/hits.h"

#include <algorithm>
#include <optional>

#include "reference/traverse.h"

namespace vkpt {
namespace {

using ReferenceHit = std::optional<reference::Hit>;

/// Whether rounding may decide what is hit: the ray passes within `margin` of an edge, in barycentrics.
bool isNearEdge(float b1, float b2, float margin) { return std::min({b1, b2, 1 - b1 - b2}) < margin; }

/// What t is off by where the corners' depths, of which it is a weighted mean, round by a few ulps.
double depthError(const SceneArrays& arrays, const reference::Ray& ray, std::uint32_t slot) {
    const TriangleRecord& t = arrays.triangles[slot];
    double reach = 0;
    for (const glm::vec3& v : {t.v0, t.v1, t.v2})
        reach = std::max(reach, glm::length(glm::dvec3(v) - glm::dvec3(ray.origin)));
    return 1e-6 * reach / glm::length(glm::dvec3(ray.direction));
}

std::string describe(const DeviceHit& hit, const ReferenceHit& expected) {
    const auto side = [](std::uint32_t slot, std::uint32_t instance, float t) {
        return slot == kNone ? std::string("nothing")
                             : fmt::format("slot {} of instance {} at t {}", slot, instance, t);
    };
    return side(hit.slot, hit.instance, hit.t) + " instead of " +
           (expected ? side(expected->triangle, expected->instance == kNone ? 0 : expected->instance, expected->t)
                     : side(kNone, 0, 0));
}

}  // namespace

bool compareHit(const SceneArrays& arrays, const reference::Ray& ray, std::uint32_t alphaKey, const DeviceHit& hit,
                const HitTolerance& tolerance, Findings& findings, HitCounts& counts) {
    ++counts.rays;
    const ReferenceHit expected = reference::closestHit(arrays, ray, alphaKey);
    const bool met = hit.slot != kNone;
    if (!met && !expected) return findings.holds("hit", true);
    const double depth = tolerance.worldDepth ? depthError(arrays, ray, met ? hit.slot : expected->triangle) : 0;
    const std::uint32_t instance = !expected || expected->instance == kNone ? 0 : expected->instance;
    if (met && expected && hit.slot == expected->triangle && hit.instance == instance) {
        ++counts.hits;
        const glm::vec2 b12(expected->barycentrics.y, expected->barycentrics.z);
        return findings.holds("hit", true) && findings.near("t", hit.t, expected->t, depth, tolerance.relative) &&
               findings.near("barycentrics", glm::vec2(hit.b1, hit.b2), b12, 10 * tolerance.relative);
    }
    const bool sameT =
        met && expected && Findings::shareOfTolerance(hit.t, expected->t, depth, tolerance.relative) <= 1;
    const bool edge = (met && isNearEdge(hit.b1, hit.b2, tolerance.edge)) ||
                      (expected && isNearEdge(expected->barycentrics.y, expected->barycentrics.z, tolerance.edge));
    if (!edge && !sameT) return findings.holds("hit", false, describe(hit, expected));
    ++counts.edges;
    findings.excuse("hit");
    return true;
}

}  // namespace vkpt
