#include <glm/gtc/matrix_transform.hpp>

#include "scene/bsdf_spec.h"
#include "verify/inputs/scenes.h"

namespace vkpt {
namespace {

/// One of each model, and more of those with distributions; glass that absorbs, too.
std::vector<BsdfSpec> specs() {
    std::vector<BsdfSpec> list;
    for (const BsdfModelInfo& model : kBsdfModels) list.push_back(defaultBsdf(model.id));
    for (const char* text :
         {"conductor:alpha=0", "conductor:alpha=0.1/0.5,distribution=beckmann,metal=Au",
          "conductor:alpha=0.4,distribution=phong", "dielectric:alpha=0", "dielectric:alpha=0.3,distribution=beckmann",
          "dielectric:alpha=0.2,ior=1.33,attenuation_color=0.9/0.5/0.1", "plastic:alpha=0.2",
          "torrance_sparrow:alpha=0.2/0.4"})
        list.push_back(parseBsdfSpec(text));
    return list;
}

}  // namespace

SceneArrays makeBsdfPatches(bool multiscatter) {
    Scene scene = makeLamps();
    scene.images.push_back(makeNoise(8, 8, 90));
    const auto list = specs();
    for (std::size_t i = 0; i < list.size(); ++i) {
        Material material = makeMaterial({0.7F, 0.5F, 0.3F}, 0.5F, 0.4F);
        if (list[i].model != BsdfId::Gltf) material.bsdf = list[i];
        material.doubleSided = i % 2 == 0;
        if (i % 3 == 0) material.normalTexture.image = 1;
        if (i % 3 == 0) material.normalScale = 0.4F;
        if (i % 4 == 1) material.baseColorTexture.image = 1;
        if (i % 5 == 1) material.metallicRoughnessTexture.image = 1;
        const auto index = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(material);
        Primitive patch = makePatch(4, index);
        if (material.normalTexture.image < 0 && i % 2 == 0) patch.tangents.clear();
        if (i % 2 == 0) patch.colors.clear();
        const float x = 0.8F * static_cast<float>(i % 7) - 2.6F, y = 0.7F * static_cast<float>(i / 7) + 0.5F;
        const bool absorbs = list[i].attenuationColor != glm::vec3(1);  // behind its front: that is what it shows
        addObject(scene, std::move(patch),
                  {makeTransform({x, y, 0.5F}, absorbs ? 0 : 10.0F * static_cast<float>(i), {0.3F, 1, 0.1F},
                                 glm::vec3(0.36F))});
    }
    SceneArrays arrays = flatten(scene, {.multiscatter = multiscatter});
    finishUnderNoise(arrays, 91);
    return arrays;
}

}  // namespace vkpt
