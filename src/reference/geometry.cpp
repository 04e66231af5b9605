#include "reference/geometry.h"

#include <algorithm>

namespace vkpt::reference {

namespace {

/// `bits` low bits of `word` as a two's complement number.
int signExtend(std::uint32_t word, int bits) {
    const int shift = 32 - bits;
    return static_cast<int>(word << shift) >> shift;
}

float largest(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

bool hasLength(const glm::vec3& v) { return glm::dot(v, v) > 0; }

struct TangentFrame {
    glm::vec3 normal{0};  ///< of the unflipped surface
    glm::vec4 tangent{0};
};

/// Interpolated vertex normal and tangent, in world space, not yet normalised.
TangentFrame interpolateFrame(const SceneArrays& scene, const TriangleRecord& triangle, const Hit& hit) {
    const std::uint32_t corners[3] = {triangle.i0, triangle.i1, triangle.i2};
    glm::vec3 n(0), t(0);
    for (int i = 0; i < 3; ++i) {
        const VertexRecord& vertex = scene.vertices[corners[i]];
        n += hit.barycentrics[i] * unpackNormal(vertex.normal);
        t += hit.barycentrics[i] * glm::vec3(unpackTangent(vertex.tangent));
    }
    float handedness = unpackTangent(scene.vertices[triangle.i0].tangent).w;
    if (hit.instance != kNone) {
        const InstanceRecord& instance = scene.instances[hit.instance];
        n = transformTransposed(instance.objectFromWorld, n);
        t = transformVector(instance.worldFromObject, t);
        const auto& rows = instance.worldFromObject;
        const float det = glm::dot(glm::vec3(rows[0]), glm::cross(glm::vec3(rows[1]), glm::vec3(rows[2])));
        if (det < 0) handedness = -handedness;
    }
    return {n, glm::vec4(t, handedness)};
}

/// The part of v across the unit vector n, normalised; 0 where it has no length.
glm::vec3 across(const glm::vec3& v, const glm::vec3& n) {
    const glm::vec3 flat = v - n * glm::dot(n, v);
    return hasLength(flat) ? glm::normalize(flat) : glm::vec3(0);
}

/// The normal of the material's normal map; n is the unit vertex normal, t the tangent across it, 0 or a unit vector.
glm::vec3 mapNormal(const SceneArrays& scene, const MaterialRecord& material, const Attributes& attributes,
                    const glm::vec3& n, const glm::vec3& t, float handedness) {
    if (!hasLength(t)) return n;
    const glm::vec3 b = handedness * glm::cross(n, t);
    const glm::vec3 texel = 2.0F * glm::vec3(sampleTexture(scene, material.normalTexture, attributes.coords)) - 1.0F;
    const glm::vec3 mapped = texel.x * material.normalScale * t + texel.y * material.normalScale * b + texel.z * n;
    return hasLength(mapped) ? glm::normalize(mapped) : n;
}

}  // namespace

glm::vec3 unpackNormal(std::uint32_t packed) {
    const glm::vec2 e(signExtend(packed, 16), signExtend(packed >> 16U, 16));
    return octDecode<float>(glm::max(e / kOctNormalMax, -1.0F));
}

glm::vec4 unpackTangent(std::uint32_t packed) {
    const glm::vec2 e(signExtend(packed, 15), signExtend(packed >> 15U, 15));
    return {octDecode<float>(glm::max(e / kOctTangentMax, -1.0F)), (packed >> 31U) != 0 ? -1.0F : 1.0F};
}

std::uint32_t objectOf(const SceneArrays& scene, const Hit& hit) {
    const std::uint32_t placed = hit.instance == kNone ? kNone : scene.instances[hit.instance].object;
    return placed == kNone ? scene.triangles[hit.triangle].object : placed;
}

std::uint32_t emitterGroup(const SceneArrays& scene, const Hit& hit) {
    return scene.lightGroups.empty() ? 0 : scene.lightGroups.ofObject[objectOf(scene, hit)];
}

float largestComponent(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return std::max({largest(a), largest(b), largest(c)});
}

ShadingPoint makeShadingPoint(const SceneArrays& scene, const Hit& hit, const Attributes& attributes,
                              const glm::vec3& wo) {
    const TriangleRecord& triangle = scene.triangles[hit.triangle];
    const MaterialRecord& material = materialOf(scene, triangle);
    glm::vec3 corners[3] = {triangle.v0, triangle.v1, triangle.v2};
    glm::vec3 ng = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    float magnitude = 0;
    if (hit.instance != kNone) {
        const InstanceRecord& instance = scene.instances[hit.instance];
        for (glm::vec3& corner : corners) corner = transformPoint(instance.worldFromObject, corner);
        ng = transformTransposed(instance.objectFromWorld, ng);
        const auto& rows = instance.worldFromObject;
        magnitude = largest({rows[0].w, rows[1].w, rows[2].w});
    }
    ng = glm::normalize(ng);
    magnitude = std::max(magnitude, largestComponent(corners[0], corners[1], corners[2]));

    ShadingPoint point;
    const glm::vec3& b = hit.barycentrics;
    point.position = b.x * corners[0] + b.y * corners[1] + b.z * corners[2];
    point.front = glm::dot(ng, wo) >= 0;
    point.ng = point.front ? ng : -ng;

    const TangentFrame frame = interpolateFrame(scene, triangle, hit);
    glm::vec3 ns = hasLength(frame.normal) ? glm::normalize(frame.normal) : ng;
    const bool mapped = material.normalTexture != kNone;
    if (mapped || (material.flags & kMaterialTangents) != 0) point.tangent = across(glm::vec3(frame.tangent), ns);
    if (mapped) ns = mapNormal(scene, material, attributes, ns, point.tangent, frame.tangent.w);
    point.ns = bendNormal(wo, point.front ? ns : -ns, point.ng);
    const glm::vec3 offset = point.ng * (kOffsetScale * magnitude);
    point.rayOrigin = point.position + offset;
    point.farOrigin = point.position - offset;
    return point;
}

}  // namespace vkpt::reference
