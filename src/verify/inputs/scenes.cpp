#include "verify/inputs/scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include "bvh/build.h"
#include "scene/environment.h"
#include "verify/inputs/random_inputs.h"

namespace vkpt {

Primitive makeQuad(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, std::uint32_t material) {
    Primitive p;
    p.positions = {corner, corner + u, corner + u + v, corner + v};
    p.normals.assign(4, glm::normalize(glm::cross(u, v)));
    p.uv0 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    p.triangles = {{0, 1, 2}, {0, 2, 3}};
    p.material = material;
    return p;
}

Primitive makePatch(std::uint32_t n, std::uint32_t material) {
    Primitive p;
    p.material = material;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const glm::vec2 uv = glm::vec2(i, j) / static_cast<float>(n);
            const float x = 2 * uv.x - 1, y = 2 * uv.y - 1;
            p.positions.push_back({x, y, 0.3F * std::sin(3 * x) * std::cos(2 * y)});
            p.normals.push_back(glm::normalize(
                glm::vec3(-0.9F * std::cos(3 * x) * std::cos(2 * y), 0.6F * std::sin(3 * x) * std::sin(2 * y), 1)));
            const glm::vec3 t = glm::normalize(glm::vec3(1, 0.2F * y, 0.5F * x));
            p.tangents.emplace_back(t, j < n / 2 ? 1 : -1);
            p.uv0.push_back(uv);
            p.uv1.push_back(glm::vec2(uv.y, 1 - uv.x) * 2.5F);
            p.colors.emplace_back(uv, 0.5F, 0.25F + 0.75F * uv.x);
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
            p.triangles.push_back({a, a + 1, b + 1});
            p.triangles.push_back({a, b + 1, b});
        }
    return p;
}

TextureImage makeNoise(std::uint32_t width, std::uint32_t height, std::uint32_t seed) {
    TextureImage image{"noise", width, height, {}};
    RandomInputs random(seed);
    for (std::uint32_t i = 0; i < width * height; ++i) image.texels.push_back(random.bits());
    return image;
}

void addObject(Scene& scene, Primitive primitive, const std::vector<glm::mat4>& placements) {
    const auto mesh = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back({"mesh", {std::move(primitive)}});
    for (const glm::mat4& matrix : placements) scene.instances.push_back({"object", mesh, matrix});
}

Material makeMaterial(const glm::vec3& base, float metallic, float roughness) {
    Material material;
    material.baseColor = glm::vec4(base, 1);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

glm::mat4 makeTransform(const glm::vec3& translation, float degrees, const glm::vec3& axis, const glm::vec3& scale) {
    const glm::mat4 moved = glm::translate(glm::mat4(1), translation);
    return glm::scale(glm::rotate(moved, glm::radians(degrees), glm::normalize(axis)), scale);
}

SceneArrays makeArrays(const Scene& scene, const FlattenOptions& options) {
    SceneArrays arrays = flatten(scene, options);
    buildBvh(arrays);
    return arrays;
}

void finishUnderNoise(SceneArrays& arrays, std::uint32_t seed) {
    EnvironmentMap map{8, 4, {}};
    RandomInputs random(seed);
    for (int i = 0; i < 32; ++i) map.texels.push_back(random.inBox({0.1F, 0.1F, 0.1F}, {0.6F, 0.7F, 0.9F}));
    addEnvironment(arrays, map, 1, 30);
    buildBvh(arrays);
}

Scene makeLamps() {
    Scene scene;
    scene.images.push_back(makeNoise(8, 5, 30));
    scene.materials.push_back(makeMaterial({0.7F, 0.6F, 0.5F}, 0, 0.6F));
    Material lamp = makeMaterial({0, 0, 0}, 0, 1);
    lamp.emissive = {9, 6, 3};
    scene.materials.push_back(lamp);
    lamp.doubleSided = true;
    scene.materials.push_back(lamp);
    lamp.doubleSided = false;
    lamp.emissiveTexture.image = 0;
    scene.materials.push_back(lamp);
    addObject(scene, makeQuad({-3, 0, 3}, {6, 0, 0}, {0, 0, -6}, 0));
    addObject(scene, makeQuad({-1, 2, -1}, {1, 0, 0}, {0, 0, 1}, 1));
    addObject(scene, makeQuad({1, 1, -1}, {0, 1, 0}, {0.3F, 0, 1}, 2));
    addObject(scene, makeQuad({-2, 0.5F, -2}, {1.5F, 0, 0}, {0, 1, 0.2F}, 3));
    scene.instances[1].name = "ceiling";
    scene.instances[2].name = "wall";
    const auto add = [&](PunctualKind kind, const glm::vec3& at, const glm::vec3& intensity, float range) {
        PunctualLight light;
        light.kind = kind;
        light.worldFromLight = makeTransform(at, -70, {1, 0.2F, 0.1F}, glm::vec3(1));
        light.intensity = intensity;
        light.range = range;
        light.innerConeAngle = 0.3F;
        light.outerConeAngle = 0.9F;
        scene.lights.push_back(light);
    };
    add(PunctualKind::Point, {0.5F, 1.5F, 1}, {4, 5, 6}, 0);
    add(PunctualKind::Point, {-1.5F, 1, 1}, {10, 8, 4}, 2.5F);
    add(PunctualKind::Spot, {0.2F, 2.5F, 0.3F}, {12, 10, 11}, 0);
    add(PunctualKind::Directional, {0, 0, 0}, {2, 1.5F, 1}, 0);
    return scene;
}

Scene makePatches() {
    Scene scene;
    scene.images = {makeNoise(8, 8, 31), makeNoise(5, 3, 32)};
    Material plain = makeMaterial({0.9F, 0.8F, 0.7F}, 0.3F, 0.4F);
    plain.baseColorTexture.image = 1;
    plain.baseColorTexture.uvSet = 1;
    Material mapped = plain;
    mapped.normalTexture.image = 0;
    mapped.normalScale = 0.7F;
    mapped.baseColorTexture.uvSet = 0;
    scene.materials = {plain, mapped};
    const std::vector<glm::mat4> placements = {makeTransform({0, 0, 0}, 0, {0, 1, 0}, {1, 1, 1}),
                                               makeTransform({5, 1, -2}, 40, {1, 2, 3}, {2, 0.5F, 1}),
                                               makeTransform({-40, 7, 9}, 200, {0, 1, 1}, {0.3F, 3, 0.7F}),
                                               makeTransform({2, -3, 100}, -75, {1, 0, 0}, {-1, 1, 2}),
                                               makeTransform({9, 0, 4}, 15, {0, 0, 1}, {1, 0.4F, -1})};
    addObject(scene, makePatch(6, 0), placements);
    addObject(scene, makePatch(5, 1), placements);
    return scene;
}

Scene makeFoliage() {
    Scene scene;
    scene.images = {makeNoise(16, 16, 33)};
    for (const AlphaMode mode : {AlphaMode::Opaque, AlphaMode::Mask, AlphaMode::Blend})
        for (const bool textured : {false, true})
            for (const bool doubleSided : {false, true}) {
                Material m = makeMaterial({0.4F, 0.7F, 0.3F}, 0, 0.8F);
                m.alphaMode = mode;
                m.alphaCutoff = 0.45F;
                m.baseColor.a = 0.8F;
                m.doubleSided = doubleSided;
                if (textured) m.baseColorTexture.image = 0;
                const auto index = static_cast<std::uint32_t>(scene.materials.size());
                scene.materials.push_back(m);
                const float k = static_cast<float>(index), side = index % 2 == 0 ? 1.0F : -1.0F;
                addObject(
                    scene, makePatch(4, index),
                    {makeTransform({0, 0, 0.4F * k}, 10 * k, {0, 0, 1}, {1, 1, 1}),
                     makeTransform({0.3F * side, 0.2F, 0.4F * k + 0.1F}, 35 * k, {1, 1, 0.5F}, {1.5F, 0.8F, side})});
            }
    return scene;
}

SceneArrays makeEverything(bool instances) {
    Scene scene = makeLamps();
    Scene leaves = makeFoliage();
    const auto firstMaterial = static_cast<std::uint32_t>(scene.materials.size());
    const auto firstMesh = static_cast<std::uint32_t>(scene.meshes.size());
    scene.images.push_back(leaves.images[0]);
    for (Material& m : leaves.materials) {
        if (m.baseColorTexture.image == 0) m.baseColorTexture.image = 1;
        scene.materials.push_back(m);
    }
    for (Mesh& mesh : leaves.meshes) {
        mesh.primitives[0].material += firstMaterial;
        scene.meshes.push_back(mesh);
    }
    for (MeshInstance& instance : leaves.instances) {
        instance.mesh += firstMesh;
        instance.worldFromObject = makeTransform({0, 1, -2}, 0, {0, 1, 0}, glm::vec3(0.4F)) * instance.worldFromObject;
        scene.instances.push_back(instance);
    }
    SceneArrays arrays = flatten(scene, {.instancing = instances, .instancingThreshold = 0});
    finishUnderNoise(arrays, 70);
    return arrays;
}

RenderOptions makeOptions(std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    RenderOptions options;
    RenderParams& p = options.params;
    p.eye = {0.5F, 2, 5};
    p.forward = glm::normalize(glm::vec3(-0.1F, -0.3F, -1));
    p.right = glm::normalize(glm::cross(p.forward, {0, 1, 0})) *
              (0.5F * static_cast<float>(width) / static_cast<float>(height));
    p.up = glm::normalize(glm::cross(p.right, p.forward)) * 0.5F;
    p.width = width;
    p.height = height;
    p.seed = 5;
    p.spp = samples;
    p.maxDepth = 5;
    p.rrMode = kRouletteThroughput;
    p.rrDepth = 3;
    options.sampleEnd = samples;
    return options;
}

SceneArrays makeFurnace() {
    Scene scene;
    Material wall = makeMaterial({1, 1, 1}, 0, 1);
    wall.emissive = {0.01F, 0.01F, 0.01F};
    scene.materials.push_back(wall);
    const float s = 8;
    addObject(scene, makeQuad({-s, -s, -s}, {2 * s, 0, 0}, {0, 2 * s, 0}, 0));
    addObject(scene, makeQuad({-s, -s, s}, {0, 2 * s, 0}, {2 * s, 0, 0}, 0));
    addObject(scene, makeQuad({-s, -s, -s}, {0, 2 * s, 0}, {0, 0, 2 * s}, 0));
    addObject(scene, makeQuad({s, -s, -s}, {0, 0, 2 * s}, {0, 2 * s, 0}, 0));
    addObject(scene, makeQuad({-s, -s, -s}, {0, 0, 2 * s}, {2 * s, 0, 0}, 0));
    addObject(scene, makeQuad({-s, s, -s}, {2 * s, 0, 0}, {0, 0, 2 * s}, 0));
    return makeArrays(scene);
}

Primitive makeHeightfield(std::uint32_t n) {
    Primitive p;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const glm::vec2 at = glm::vec2(i, j) * (6 / static_cast<float>(n)) - 3.0F;
            p.positions.push_back({at.x, 0.4F * std::sin(5 * at.x) * std::cos(4 * at.y), at.y});
            p.normals.push_back({0, 1, 0});
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
            p.triangles.push_back({a, b, a + 1});
            p.triangles.push_back({a + 1, b, b + 1});
        }
    return p;
}

}  // namespace vkpt
