#include "verify/stages/hits.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "reference/traverse.h"
#include "verify/stages/rounding.h"

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

std::uint32_t instanceOf(const reference::Hit& hit) { return hit.instance == kNone ? 0 : hit.instance; }

bool isInside(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& tolerance) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), tolerance));
}

std::string describe(const DeviceHit& hit, const ReferenceHit& expected) {
    const auto side = [](std::uint32_t slot, std::uint32_t instance, float t) {
        return slot == kNone ? std::string("nothing")
                             : fmt::format("slot {} of instance {} at t {}", slot, instance, t);
    };
    return side(hit.slot, hit.instance, hit.t) + " instead of " +
           (expected ? side(expected->triangle, instanceOf(*expected), expected->t) : side(kNone, 0, 0));
}

/// t and barycentrics.
glm::dvec3 numbersOf(float t, float b1, float b2) { return {t, b1, b2}; }

/// Whether the reference meets the same along some rays within rounding of this one, and the numbers lie among theirs.
bool isMetNearby(const SceneArrays& arrays, const reference::Ray& ray, std::uint32_t alphaKey, const DeviceHit& hit,
                 const glm::dvec3& tolerance) {
    constexpr int kAttempts = 32;
    Jitter jitter(2);
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const ReferenceHit other = reference::closestHit(arrays, jitter.near(ray), alphaKey);
        if (!other && hit.slot == kNone) return true;
        if (!other || other->triangle != hit.slot || instanceOf(*other) != hit.instance) continue;
        const glm::dvec3 numbers = numbersOf(other->t, other->barycentrics.y, other->barycentrics.z);
        low = glm::min(low, numbers - tolerance);
        high = glm::max(high, numbers + tolerance);
    }
    const glm::dvec3 numbers = numbersOf(hit.t, hit.b1, hit.b2);
    return glm::all(glm::greaterThanEqual(numbers, low)) && glm::all(glm::lessThanEqual(numbers, high));
}

}  // namespace

bool compareHit(const SceneArrays& arrays, const reference::Ray& ray, std::uint32_t alphaKey, const DeviceHit& hit,
                const HitTolerance& tolerance, Findings& findings, HitCounts& counts) {
    ++counts.rays;
    const ReferenceHit expected = reference::closestHit(arrays, ray, alphaKey);
    const bool met = hit.slot != kNone;
    if (!met && !expected) return findings.holds("hit", true);
    const double depth = tolerance.worldDepth ? depthError(arrays, ray, met ? hit.slot : expected->triangle) : 0;
    const double share = 10 * tolerance.relative;
    const glm::dvec3 allowed(depth + tolerance.relative * double{met ? hit.t : expected->t}, share, share);
    const auto nearby = [&] {
        if (!tolerance.jitter || !isMetNearby(arrays, ray, alphaKey, hit, allowed)) return false;
        findings.excuse("hit");
        return true;
    };
    if (met && expected && hit.slot == expected->triangle && hit.instance == instanceOf(*expected)) {
        ++counts.hits;
        const glm::vec2 b12(expected->barycentrics.y, expected->barycentrics.z);
        const bool inside = isInside(numbersOf(hit.t, hit.b1, hit.b2), numbersOf(expected->t, b12.x, b12.y), allowed);
        if (!inside && nearby()) return true;
        return findings.holds("hit", true) && findings.near("t", hit.t, expected->t, depth, tolerance.relative) &&
               findings.near("barycentrics", glm::vec2(hit.b1, hit.b2), b12, share);
    }
    const bool sameT =
        met && expected && Findings::shareOfTolerance(hit.t, expected->t, depth, tolerance.relative) <= 1;
    const bool edge = (met && isNearEdge(hit.b1, hit.b2, tolerance.edge)) ||
                      (expected && isNearEdge(expected->barycentrics.y, expected->barycentrics.z, tolerance.edge));
    if (edge || sameT)
        findings.excuse("hit");
    else if (!nearby())
        return findings.holds("hit", false, describe(hit, expected));
    ++counts.edges;
    return true;
}

}  // namespace vkpt
