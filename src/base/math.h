// Small vector mathematics of the host: luminance and the octahedral packing of layout.h.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

#include "constants.h"

namespace vkpt {

/// Rec. 709 luminance of a linear colour.
[[nodiscard]] inline float luminance(const glm::vec3& color) {
    return 0.2126F * color.r + 0.7152F * color.g + 0.0722F * color.b;
}

/// IEC 61966-2-1: display-encoded value in [0,1] to linear light.
[[nodiscard]] inline float srgbToLinear(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

[[nodiscard]] inline bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Unit vector to the octahedral square [-1,1]^2. [Cigolle 14] A zero vector maps to +z.
[[nodiscard]] inline glm::vec2 octahedralEncode(const glm::vec3& n) {
    const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(sum > 0)) return {0, 0};
    const glm::vec2 p{n.x / sum, n.y / sum};
    if (n.z >= 0) return p;
    return {(1 - std::abs(p.y)) * (p.x >= 0 ? 1.0F : -1.0F), (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0F : -1.0F)};
}

/// Inverse of octahedralEncode; returns a unit vector.
[[nodiscard]] inline glm::vec3 octahedralDecode(const glm::vec2& p) {
    glm::vec3 n{p.x, p.y, 1 - std::abs(p.x) - std::abs(p.y)};
    if (n.z < 0) {
        n.x = (1 - std::abs(p.y)) * (p.x >= 0 ? 1.0F : -1.0F);
        n.y = (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0F : -1.0F);
    }
    return glm::normalize(n);
}

/// VertexRecord.normal of a unit vector. Vectors along an axis come back exactly.
[[nodiscard]] inline std::uint32_t packNormal(const glm::vec3& n) {
    const glm::vec2 p = octahedralEncode(n) * kOctNormalMax;
    const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lrint(p.x)));
    const auto y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lrint(p.y)));
    return (x & 0xffffU) | y << 16U;
}

[[nodiscard]] inline glm::vec3 unpackNormal(std::uint32_t bits) {
    const auto x = static_cast<std::int32_t>(bits << 16U) >> 16;
    const auto y = static_cast<std::int32_t>(bits) >> 16;
    return octahedralDecode(glm::vec2(static_cast<float>(x), static_cast<float>(y)) / kOctNormalMax);
}

/// VertexRecord.tangent of a unit vector and its handedness w, +1 or -1.
[[nodiscard]] inline std::uint32_t packTangent(const glm::vec4& t) {
    const glm::vec2 p = octahedralEncode(glm::vec3(t)) * kOctTangentMax;
    const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lrint(p.x)));
    const auto y = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lrint(p.y)));
    return (x & 0x7fffU) | (y & 0x7fffU) << 15U | (t.w < 0 ? 0x80000000U : 0U);
}

[[nodiscard]] inline glm::vec4 unpackTangent(std::uint32_t bits) {
    const auto x = static_cast<std::int32_t>(bits << 17U) >> 17;
    const auto y = static_cast<std::int32_t>(bits << 2U) >> 17;
    const glm::vec2 p = glm::vec2(static_cast<float>(x), static_cast<float>(y)) / kOctTangentMax;
    return {octahedralDecode(p), (bits & 0x80000000U) != 0 ? -1.0F : 1.0F};
}

}  // namespace vkpt
