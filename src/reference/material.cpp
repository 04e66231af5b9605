#include "reference/material.h"

namespace vkpt::reference {

namespace {

glm::vec4 unpackColor(const VertexExtra& extra) {
    return glm::vec4(extra.colorRG & 0xffffU, extra.colorRG >> 16U, extra.colorBA & 0xffffU, extra.colorBA >> 16U) /
           65535.0F;
}

}  // namespace

Attributes interpolateAttributes(const SceneArrays& scene, const TriangleRecord& triangle, const glm::vec3& b) {
    const std::uint32_t corners[3] = {triangle.i0, triangle.i1, triangle.i2};
    Attributes at;
    if (!scene.vertexExtras.empty()) at.color = glm::vec4(0);
    for (int i = 0; i < 3; ++i) {
        const VertexRecord& vertex = scene.vertices[corners[i]];
        at.coords.uv0 += b[i] * glm::vec2(vertex.u0, vertex.v0);
        if (scene.vertexExtras.empty()) continue;
        const VertexExtra& extra = scene.vertexExtras[corners[i]];
        at.coords.uv1 += b[i] * glm::vec2(extra.u1, extra.v1);
        at.color += b[i] * unpackColor(extra);
    }
    return at;
}

glm::vec4 baseColor(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at) {
    glm::vec4 color = material.baseColor;
    if (material.baseColorTexture != kNone) color *= sampleTexture(scene, material.baseColorTexture, at.coords);
    if ((material.flags & kMaterialVertexColor) != 0) color *= at.color;
    return color;
}

glm::vec3 emission(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at) {
    if (material.emissiveTexture == kNone) return material.emissive;
    return material.emissive * glm::vec3(sampleTexture(scene, material.emissiveTexture, at.coords));
}

glm::vec2 metallicRoughness(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at) {
    const glm::vec2 factors(material.metallic, material.roughness);
    if (material.metallicRoughnessTexture == kNone) return factors;
    const glm::vec4 texel = sampleTexture(scene, material.metallicRoughnessTexture, at.coords);
    return factors * glm::vec2(texel.b, texel.g);
}

bool isPresent(const SceneArrays& scene, const Hit& hit, std::uint32_t alphaKey) {
    const TriangleRecord& triangle = scene.triangles[hit.triangle];
    const MaterialRecord& material = materialOf(scene, triangle);
    const float alpha = baseColor(scene, material, interpolateAttributes(scene, triangle, hit.barycentrics)).a;
    if ((material.flags & kMaterialAlphaMask) != 0) return alpha >= material.alphaCutoff;
    const std::uint32_t instance = hit.instance == kNone ? 0 : hit.instance;
    return toUnit(hash({alphaKey, instance, triangle.primitive, kSaltAlpha}).x) < alpha;
}

}  // namespace vkpt::reference
