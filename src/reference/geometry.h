// From a hit to the point that is shaded: positions, normals, bent normal, ray origins. estimator.md, Shading point.
#pragma once
#include "reference/hit.h"
#include "reference/material.h"
#include "reference/real.h"

namespace vkpt::reference {

/// Unit vector of two snorm coordinates on the octahedron. [Cigolle 14]
template <class Real>
[[nodiscard]] Vec3<Real> octDecode(const Vec2<Real>& e) {
    Vec3<Real> v(e, 1 - std::abs(e.x) - std::abs(e.y));
    if (v.z < 0) {
        const Vec2<Real> folded(1 - std::abs(e.y), 1 - std::abs(e.x));
        v.x = e.x >= 0 ? folded.x : -folded.x;
        v.y = e.y >= 0 ? folded.y : -folded.y;
    }
    return glm::normalize(v);
}

[[nodiscard]] glm::vec3 unpackNormal(std::uint32_t packed);
/// xyz: unit tangent; w: handedness, 1 or -1.
[[nodiscard]] glm::vec4 unpackTangent(std::uint32_t packed);

/// Turns ns until the mirror direction of wo leaves the surface by 0.01. ng faces wo. [Keller 17, app. A.3]
template <class Real>
[[nodiscard]] Vec3<Real> bendNormal(const Vec3<Real>& wo, const Vec3<Real>& ns, const Vec3<Real>& ng) {
    constexpr Real kLeast = Real(0.01);
    const Vec3<Real> mirrored = 2 * glm::dot(wo, ns) * ns - wo;
    const Real rise = glm::dot(mirrored, ng);
    if (rise >= kLeast) return ns;
    return glm::normalize(wo + glm::normalize(mirrored + ng * (kLeast - rise)));
}

/// Where, and between which normals, light is scattered.
struct ShadingPoint {
    glm::vec3 position{0};
    glm::vec3 ng{0, 0, 1};   ///< geometric normal on wo's side
    glm::vec3 ns{0, 0, 1};   ///< shading normal, normal map applied, bent
    glm::vec3 tangent{0};    ///< T of the normal map's frame, across the vertex normal; 0 where there is none
    glm::vec3 rayOrigin{0};  ///< of all rays that leave on wo's side
    glm::vec3 farOrigin{0};  ///< of all rays that go through
    bool front = true;       ///< wo is on the front of the triangle
};

[[nodiscard]] ShadingPoint makeShadingPoint(const SceneArrays& scene, const Hit& hit, const Attributes& attributes,
                                            const glm::vec3& wo);

/// The mesh instance that a hit is on.
[[nodiscard]] std::uint32_t objectOf(const SceneArrays& scene, const Hit& hit);
/// The light group of what it emits; 0 where the scene has no groups.
[[nodiscard]] std::uint32_t emitterGroup(const SceneArrays& scene, const Hit& hit);

/// Largest |component| of three points.
[[nodiscard]] float largestComponent(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace vkpt::reference
