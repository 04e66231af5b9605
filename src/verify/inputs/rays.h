// Rays that meet a set of triangles in every awkward way.
#pragma once
#include <vector>

#include "verify/inputs/soups.h"

namespace vkpt {

struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, 1};
};

/// What rays aim at: also vertices and edges, or only the inside of triangles (and nothing in particular).
enum class Aim { Anywhere, Inside };

/// Towards random points of random triangles, from inside and outside the box of all; along the axes; and at random.
inline std::vector<Ray> raysAt(const Triangles& triangles, std::size_t n, Aim aim = Aim::Anywhere) {
    Random random(3);
    glm::dvec3 lo(1e300), hi(-1e300);
    for (const TriangleRecord& t : triangles) {
        lo = glm::min(lo, glm::dvec3(glm::min(t.v0, glm::min(t.v1, t.v2))));
        hi = glm::max(hi, glm::dvec3(glm::max(t.v0, glm::max(t.v1, t.v2))));
    }
    if (triangles.empty()) lo = glm::dvec3(-1), hi = glm::dvec3(1);
    const glm::dvec3 middle = 0.5 * (lo + hi), extent = glm::max(hi - lo, 1e-6 * glm::length(hi - lo));
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < n; ++i) {
        Ray ray;
        ray.origin = middle + extent * glm::dvec3(random.vec()) * (i % 3 == 0 ? 0.5 : 1.5);
        ray.direction = glm::dvec3(random.vec());
        if (!triangles.empty() && i % 5 != 0) {
            const auto pick = static_cast<std::size_t>((random() + 1) * 0.5F * static_cast<float>(triangles.size()));
            const TriangleRecord& t = triangles[std::min(pick, triangles.size() - 1)];
            const bool border = aim == Aim::Anywhere;
            const double u = border && i % 5 == 1 ? 0.0 : 0.3;
            const double v = border && (i % 5 == 2 || i % 10 == 1) ? 0.0 : (0.1 + 0.4 * (random() + 1)) * (1 - u);
            const glm::dvec3 target = (1 - u - v) * glm::dvec3(t.v0) + u * glm::dvec3(t.v1) + v * glm::dvec3(t.v2);
            ray.direction = target - ray.origin;
            if (i % 5 == 4) {  // along an axis, through the target
                const vec3 normal = glm::abs(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
                int axis = static_cast<int>(i / 5 % 3);
                // A ray within the plane of its target has no answer that rounding would leave alone.
                if (!border) axis = normal.x > normal.y ? (normal.x > normal.z ? 0 : 2) : (normal.y > normal.z ? 1 : 2);
                const double side = i / 15 % 2 == 0 ? 1 : -1;
                ray.direction = glm::dvec3(0);
                ray.direction[axis] = -side;
                ray.origin = target;
                ray.origin[axis] += side * 2 * std::max(extent[axis], 1e-30);
            }
        }
        if (ray.direction != glm::dvec3(0)) rays.push_back(ray);
    }
    return rays;
}

}  // namespace vkpt
