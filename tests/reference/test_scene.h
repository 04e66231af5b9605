// Small scenes made by hand, and a way to render them.
#pragma once
#include <string>
#include <vector>

#include "bvh/build.h"
#include "film/film.h"
#include "reference/render.h"
#include "scene/environment.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace vkpt::test {

/// Collects meshes of plain quads and boxes under materials.
class SceneBuilder {
public:
    /// Returns the material's index.
    std::uint32_t material(const Material& material) {
        scene_.materials.push_back(material);
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    /// Parallelogram with corners o, o+a, o+a+b, o+b; its front has normal cross(a, b). TEXCOORD_0 spans [0,1]^2.
    SceneBuilder& quad(std::uint32_t materialIndex, glm::vec3 o, glm::vec3 a, glm::vec3 b) {
        Primitive p;
        p.material = materialIndex;
        p.positions = {o, o + a, o + a + b, o + b};
        p.normals.assign(4, glm::normalize(glm::cross(a, b)));
        p.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        p.triangles = {{0, 1, 2}, {0, 2, 3}};
        return mesh({std::move(p)}, glm::mat4(1));
    }

    /// Closed box [-h, h]^3 around c seen from inside: fronts face inwards.
    SceneBuilder& roomAround(std::uint32_t materialIndex, glm::vec3 c, float h) {
        const glm::vec3 x(2 * h, 0, 0), y(0, 2 * h, 0), z(0, 0, 2 * h), lo = c - h, hi = c + h;
        quad(materialIndex, lo, y, z).quad(materialIndex, lo, z, x).quad(materialIndex, lo, x, y);
        return quad(materialIndex, hi, -z, -y).quad(materialIndex, hi, -x, -z).quad(materialIndex, hi, -y, -x);
    }

    SceneBuilder& mesh(std::vector<Primitive> primitives, const glm::mat4& matrix) {
        scene_.meshes.push_back({"mesh", std::move(primitives)});
        return place(static_cast<std::uint32_t>(scene_.meshes.size() - 1), matrix);
    }

    SceneBuilder& place(std::uint32_t meshIndex, const glm::mat4& matrix) {
        scene_.instances.push_back({"instance", meshIndex, matrix});
        return *this;
    }

    SceneBuilder& light(const PunctualLight& light) {
        scene_.lights.push_back(light);
        return *this;
    }

    Scene& scene() { return scene_; }

    [[nodiscard]] SceneArrays build(const EnvironmentMap* environment = nullptr,
                                    const FlattenOptions& options = {}) const {
        SceneArrays arrays = flatten(scene_, options);
        if (environment) addEnvironment(arrays, *environment, 1, 0);
        buildBvh(arrays);
        return arrays;
    }

    [[nodiscard]] SceneArrays build(const glm::vec3& environment) const {
        const EnvironmentMap map = constantEnvironment(environment);
        return build(&map);
    }

private:
    Scene scene_;
};

inline Material matte(const glm::vec3& base) {
    Material m;
    m.baseColor = glm::vec4(base, 1);
    m.metallic = 0;
    m.roughness = 1;
    return m;
}

inline Material metal(const glm::vec3& base, float roughness) {
    Material m;
    m.baseColor = glm::vec4(base, 1);
    m.metallic = 1;
    m.roughness = roughness;
    return m;
}

inline Material emitter(const glm::vec3& nits) {
    Material m = matte(glm::vec3(0));
    m.emissive = nits;
    return m;
}

/// Orthographic view along -z of the window [-half, half]^2 at z = distance.
inline RenderOptions viewAlongZ(std::uint32_t side, float half, std::uint32_t spp, std::uint32_t maxDepth,
                                float distance = 5) {
    RenderOptions options;
    RenderParams& p = options.params;
    p.eye = {0, 0, distance};
    p.projection = kProjectionOrthographic;
    p.right = {half, 0, 0};
    p.up = {0, half, 0};
    p.forward = {0, 0, -1};
    p.width = p.height = side;
    p.spp = options.sampleEnd = spp;
    p.maxDepth = maxDepth;
    return options;
}

/// The same window seen under `cosine` to the plane z = 0, from +x: every camera ray has that direction.
inline RenderOptions viewAtAngle(float cosine, float half, std::uint32_t spp, std::uint32_t maxDepth) {
    RenderOptions options = viewAlongZ(4, half, spp, maxDepth);
    const float sine = std::sqrt(1 - cosine * cosine);
    options.params.forward = {-sine, 0, -cosine};
    options.params.eye = -5.0F * options.params.forward;
    options.params.right = {half * cosine, 0, -half * sine};
    return options;
}

/// Mean of all pixels.
inline glm::dvec4 meanOf(const Film& film) {
    const Image image = filmToImage(film);
    glm::dvec4 sum(0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) sum[static_cast<int>(i % 4)] += double{image.pixels[i]};
    return sum / static_cast<double>(image.width) / static_cast<double>(image.height);
}

}  // namespace vkpt::test
