#include "gltf/normals.h"

#include <cmath>

namespace vkpt::gltf {
namespace {

// Twice the area times the normal; in double, since products of large coordinates overflow float.
glm::dvec3 areaVector(const std::vector<glm::vec3>& positions, const glm::uvec3& t) {
    const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
    return glm::cross(b - a, c - a);
}

// A direction for what has none: any unit vector serves.
constexpr glm::vec3 kAnyNormal{0, 0, 1};

glm::vec3 unitOrAny(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? glm::vec3(v / length) : kAnyNormal;
}

template <typename T>
void unshare(std::vector<T>& values, const std::vector<glm::uvec3>& triangles) {
    if (values.empty()) return;
    std::vector<T> out;
    out.reserve(triangles.size() * 3);
    for (const glm::uvec3& t : triangles)
        for (glm::length_t c = 0; c < 3; ++c) out.push_back(values[t[c]]);
    values = std::move(out);
}

}  // namespace

void makeFlat(Primitive& primitive) {
    unshare(primitive.positions, primitive.triangles);
    unshare(primitive.uv0, primitive.triangles);
    unshare(primitive.uv1, primitive.triangles);
    unshare(primitive.colors, primitive.triangles);
    primitive.normals.resize(primitive.positions.size());
    for (std::size_t i = 0; i < primitive.triangles.size(); ++i) {
        const auto first = static_cast<std::uint32_t>(3 * i);
        primitive.triangles[i] = {first, first + 1, first + 2};
        const glm::vec3 normal = unitOrAny(areaVector(primitive.positions, primitive.triangles[i]));
        for (std::size_t c = 0; c < 3; ++c) primitive.normals[first + c] = normal;
    }
}

}  // namespace vkpt::gltf
