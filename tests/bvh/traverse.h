// A plain traversal of the wide tree and brute force beside it, both on one intersection routine in double.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bvh/wide_node.h"
#include "scene/scene_arrays.h"
#include "verify/inputs/rays.h"

namespace vkpt {

struct Hit {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t instance = kNone, primitive = kNone;

    [[nodiscard]] bool any() const { return primitive != kNone; }
    bool operator==(const Hit&) const = default;
    /// estimator.md: of two hits at equal t the one with the lower primitive wins.
    [[nodiscard]] bool closerThan(const Hit& o) const {
        return t < o.t || (t == o.t && std::pair(primitive, instance) < std::pair(o.primitive, o.instance));
    }
};

/// [Moeller 97], both faces.
inline std::optional<double> intersectTriangle(const Ray& ray, const TriangleRecord& tri) {
    const glm::dvec3 v0(tri.v0), e1 = glm::dvec3(tri.v1) - v0, e2 = glm::dvec3(tri.v2) - v0;
    const glm::dvec3 p = glm::cross(ray.direction, e2), s = ray.origin - v0, q = glm::cross(s, e1);
    const double det = glm::dot(e1, p);
    if (det == 0) return {};
    const double u = glm::dot(s, p) / det, v = glm::dot(ray.direction, q) / det, t = glm::dot(e2, q) / det;
    if (u < 0 || v < 0 || u + v > 1 || !(t > 0)) return {};
    return t;
}

/// Slab test in double; a relative margin far above its rounding and far below float's.
inline bool meetsBox(const Ray& ray, const Box& box, double tMax) {
    double enter = 0, leave = tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const double lo = box.lo[axis], hi = box.hi[axis], o = ray.origin[axis], d = ray.direction[axis];
        const double margin = 1e-10 * (std::abs(lo) + std::abs(hi) + std::abs(o));
        if (d == 0) {
            if (o < lo - margin || o > hi + margin) return false;
            continue;
        }
        const double a = (lo - margin - o) / d, b = (hi + margin - o) / d;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave * (1 + 1e-10);
}

inline Ray toObject(const Ray& ray, const InstanceRecord& instance) {
    Ray object;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec4 row(instance.objectFromWorld[axis]);
        object.origin[axis] = glm::dot(row, glm::dvec4(ray.origin, 1));
        object.direction[axis] = glm::dot(row, glm::dvec4(ray.direction, 0));
    }
    return object;
}

enum class SlotOrder { NearFirst, Reversed };

class WideTraversal {
public:
    explicit WideTraversal(const SceneArrays& arrays, SlotOrder order = SlotOrder::NearFirst)
        : arrays_(arrays), flip_(order == SlotOrder::Reversed ? 7U : 0U) {}

    Hit closest(const Ray& ray) {
        Hit hit;
        walk(arrays_.rootNode, ray, !arrays_.instances.empty(), kNone, hit, 0);
        return hit;
    }
    [[nodiscard]] std::size_t nodeVisits() const { return visits_; }

private:
    /// One stack entry a level, the slots not yet visited, as wide_node.h promises to suffice.
    struct Entry {
        std::uint32_t node, visited;  // visited: slots ^ octant below this are done
    };

    void walk(std::uint32_t root, const Ray& ray, bool top, std::uint32_t instance, Hit& hit, std::size_t used) {
        const std::uint32_t octant =
            (ray.direction.x < 0 ? 1U : 0U) | (ray.direction.y < 0 ? 2U : 0U) | (ray.direction.z < 0 ? 4U : 0U);
        std::vector<Entry> stack{{root, 0}};
        ++visits_;
        while (!stack.empty()) {
            ASSERT_LE(used + stack.size(), std::size_t{arrays_.bvhDepth});
            Entry& entry = stack.back();
            if (entry.visited == kWideNodeSlots) {
                stack.pop_back();
                continue;
            }
            const WideChild child = wideChild(arrays_.nodes[entry.node], entry.visited++ ^ octant ^ flip_);
            if (child.kind == WideChildKind::Empty || !meetsBox(ray, child.box, hit.t)) continue;
            if (child.kind == WideChildKind::Inner) {
                stack.push_back({child.first, 0});
                ++visits_;
                continue;
            }
            for (std::uint32_t i = child.first; i < child.first + child.count; ++i) {
                if (top) {
                    walk(arrays_.instances[i].rootNode, toObject(ray, arrays_.instances[i]), false, i, hit,
                         used + stack.size());
                } else {
                    test(i, ray, instance, hit);
                }
            }
        }
    }

    void test(std::uint32_t triangle, const Ray& ray, std::uint32_t instance, Hit& hit) const {
        const auto t = intersectTriangle(ray, arrays_.triangles[triangle]);
        if (!t) return;
        const Hit candidate{*t, instance, arrays_.triangles[triangle].primitive};
        if (candidate.closerThan(hit)) hit = candidate;
    }

    const SceneArrays& arrays_;
    std::uint32_t flip_;
    std::size_t visits_ = 0;
};

inline void testAll(std::span<const TriangleRecord> triangles, const Ray& ray, std::uint32_t instance, Hit& hit) {
    for (const TriangleRecord& triangle : triangles) {
        const auto t = intersectTriangle(ray, triangle);
        if (!t) continue;
        const Hit candidate{*t, instance, triangle.primitive};
        if (candidate.closerThan(hit)) hit = candidate;
    }
}

inline Hit bruteForce(const SceneArrays& arrays, const Ray& ray) {
    Hit hit;
    if (arrays.instances.empty()) testAll(arrays.triangles, ray, kNone, hit);
    for (std::uint32_t i = 0; i < arrays.instances.size(); ++i) {
        const MeshRange& range = arrays.meshRanges[arrays.instanceMesh[i]];
        testAll(std::span(arrays.triangles).subspan(range.firstTriangle, range.triangleCount),
                toObject(ray, arrays.instances[i]), i, hit);
    }
    return hit;
}

}  // namespace vkpt
