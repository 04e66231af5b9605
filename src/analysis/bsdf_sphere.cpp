#include "analysis/bsdf_sphere.h"

#include <cmath>
#include <numbers>

#include "bvh/build.h"
#include "film/film.h"
#include "film/tonemap.h"
#include "reference/render.h"
#include "scene/camera.h"
#include "scene/environment.h"
#include "scene/flatten.h"

namespace vkpt {
namespace {

/// Unit sphere about the origin, poles on y; TEXCOORD_0 and tangents run along the parallels.
Primitive sphere() {
    constexpr std::uint32_t kRows = 64, kColumns = 128;
    Primitive p;
    for (std::uint32_t j = 0; j <= kRows; ++j) {
        for (std::uint32_t i = 0; i <= kColumns; ++i) {
            const float u = static_cast<float>(i) / kColumns, v = static_cast<float>(j) / kRows;
            const float phi = 2 * std::numbers::pi_v<float> * u, theta = std::numbers::pi_v<float> * v;
            const glm::vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            p.positions.push_back(n);
            p.normals.push_back(n);
            p.tangents.emplace_back(std::cos(phi), 0, -std::sin(phi), 1);
            p.uv0.emplace_back(u, v);
        }
    }
    for (std::uint32_t j = 0; j < kRows; ++j) {
        for (std::uint32_t i = 0; i < kColumns; ++i) {
            const std::uint32_t a = j * (kColumns + 1) + i, b = a + kColumns + 1;
            if (j > 0) p.triangles.emplace_back(a, b, a + 1);
            if (j + 1 < kRows) p.triangles.emplace_back(a + 1, b, b + 1);
        }
    }
    return p;
}

}  // namespace

Image renderBsdfSphere(const BsdfSpec& spec, bool multiscatter, std::uint32_t side, std::uint32_t spp) {
    Scene scene;
    Material material;
    if (spec.model == BsdfId::Gltf) {
        material.baseColor = glm::vec4(spec.color, 1);
        material.metallic = spec.metallic;
        material.roughness = spec.sigma;
    } else {
        material.bsdf = spec;
    }
    scene.materials.push_back(material);
    scene.meshes.push_back({"sphere", {sphere()}});
    scene.instances.push_back({"sphere", 0, glm::mat4(1)});
    SceneArrays arrays = flatten(scene, {.multiscatter = multiscatter});
    addEnvironment(arrays, studioEnvironment(), 1, 0);
    buildBvh(arrays);

    RenderOptions options;
    options.params.width = options.params.height = side;
    options.params.spp = options.sampleEnd = spp;
    options.params.maxDepth = 12;
    options.params.background = glm::vec3(0.18F);
    options.params.backgroundMode = kBackgroundColor;
    lookAt(options.params, {0, 1.2F, 4}, {0, 0, 0}, 33);
    return displayImage(filmToImage(renderReference(arrays, options)), {});
}

}  // namespace vkpt
