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

glm::vec3 colorMap(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at) {
    glm::vec3 color(1);
    if (material.baseColorTexture != kNone)
        color = glm::vec3(sampleTexture(scene, material.baseColorTexture, at.coords));
    if ((material.flags & kMaterialVertexColor) != 0) color *= glm::vec3(at.color);
    return color;
}

float roughnessMap(const SceneArrays& scene, const MaterialRecord& material, const Attributes& at) {
    if (material.metallicRoughnessTexture == kNone) return 1;
    return sampleTexture(scene, material.metallicRoughnessTexture, at.coords).g;
}

Bsdf<float> bsdfOf(const SceneArrays& scene, const TriangleRecord& triangle, const Attributes& at, bool front) {
    const MaterialRecord& material = materialOf(scene, triangle);
    const BsdfId model = modelOf(material);
    if (model != BsdfId::Gltf) {
        const BsdfRecord& record = scene.bsdfs[triangle.flags >> kTriangleMaterialShift];
        return makeBsdf(model, record, colorMap(scene, material, at), roughnessMap(scene, material, at), front, scene);
    }
    const glm::vec2 mr = metallicRoughness(scene, material, at);
    Bsdf<float> b = makeGltfBsdf(glm::vec3(baseColor(scene, material, at)), mr.x, mr.y * mr.y);
    if (scene.features.multiscatter) {
        b.multiscatter = true;
        b.table.cells = scene.albedoTables.data();
    }
    return b;
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
