// Small scenes in memory, for the tests of this folder.
#pragma once
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "scene/flatten.h"

namespace vkpt {

/// Unit right triangle in the plane z = 0, its front towards +z, with all it takes for a normal map.
inline Primitive trianglePrimitive(std::uint32_t material = 0) {
    Primitive p;
    p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    p.normals.assign(3, {0, 0, 1});
    p.tangents.assign(3, {1, 0, 0, 1});
    p.uv0 = {{0, 0}, {1, 0}, {0, 1}};
    p.triangles = {{0, 1, 2}};
    p.material = material;
    return p;
}

/// n x n quads over [-1,1]^2 in the plane z = 0.
inline Primitive gridPrimitive(std::uint32_t n, std::uint32_t material = 0) {
    Primitive p;
    p.material = material;
    for (std::uint32_t y = 0; y <= n; ++y) {
        for (std::uint32_t x = 0; x <= n; ++x) {
            const glm::vec2 uv = glm::vec2(x, y) / static_cast<float>(n);
            p.positions.emplace_back(uv * 2.0F - 1.0F, 0);
            p.normals.emplace_back(0, 0, 1);
            p.uv0.push_back(uv);
        }
    }
    for (std::uint32_t y = 0; y < n; ++y) {
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t i = y * (n + 1) + x;
            p.triangles.emplace_back(i, i + 1, i + n + 2);
            p.triangles.emplace_back(i, i + n + 2, i + n + 1);
        }
    }
    return p;
}

/// One mesh of one primitive, placed by each matrix.
inline Scene sceneOf(Primitive primitive, const std::vector<glm::mat4>& places = {glm::mat4(1)}) {
    Scene scene;
    scene.path = "memory.gltf";
    scene.materials.resize(primitive.material + 1);
    scene.meshes.resize(1);
    scene.meshes[0].primitives.push_back(std::move(primitive));
    for (const glm::mat4& place : places) scene.instances.push_back({"node", 0, place});
    return scene;
}

inline TextureImage imageOf(std::uint32_t width, std::uint32_t height, std::uint32_t texel) {
    return {"image", width, height, std::vector<std::uint32_t>(std::size_t{width} * height, texel)};
}

inline glm::vec3 faceNormal(const TriangleRecord& t) { return glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0)); }

/// A uniform double in [0,1) from an index: the golden-ratio sequence.
inline double golden(std::uint64_t i) {
    const double x = static_cast<double>(i) * 0.6180339887498949;
    return x - static_cast<double>(static_cast<std::uint64_t>(x));
}

}  // namespace vkpt
