// Rays and what they meet.
#pragma once
#include <limits>

#include "scene/scene_arrays.h"

namespace vkpt::reference {

/// Points origin + t direction with 0 < t; `direction` need not be a unit vector.
struct Ray {
    glm::vec3 origin{0}, direction{0, 0, 1};
};

struct Hit {
    float t = std::numeric_limits<float>::infinity();
    glm::vec3 barycentrics{0};       ///< weights of v0, v1, v2
    std::uint32_t triangle = kNone;  ///< slot in SceneArrays::triangles
    std::uint32_t instance = kNone;  ///< index of the InstanceRecord; kNone where nothing is instanced
};

[[nodiscard]] inline glm::vec3 transformPoint(const glm::vec4 (&rows)[3], const glm::vec3& p) {
    const glm::vec4 q(p, 1.0F);
    return {glm::dot(rows[0], q), glm::dot(rows[1], q), glm::dot(rows[2], q)};
}

[[nodiscard]] inline glm::vec3 transformVector(const glm::vec4 (&rows)[3], const glm::vec3& v) {
    return {glm::dot(glm::vec3(rows[0]), v), glm::dot(glm::vec3(rows[1]), v), glm::dot(glm::vec3(rows[2]), v)};
}

/// The transpose applied to v: takes normals the other way through `rows`.
[[nodiscard]] inline glm::vec3 transformTransposed(const glm::vec4 (&rows)[3], const glm::vec3& v) {
    return glm::vec3(rows[0]) * v.x + glm::vec3(rows[1]) * v.y + glm::vec3(rows[2]) * v.z;
}

}  // namespace vkpt::reference
