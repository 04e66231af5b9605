#include "gltf/extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace vkpt::gltf {
namespace {

constexpr std::array<std::string_view, 6> kHonoured = {"KHR_lights_punctual",   "KHR_materials_emissive_strength",
                                                       "KHR_materials_unlit",   "KHR_mesh_quantization",
                                                       "KHR_texture_transform", "VKPT_materials_bsdf"};

bool isHonoured(std::string_view name) {
    return std::find(kHonoured.begin(), kHonoured.end(), name) != kHonoured.end();
}

bool hasMorphTargets(const Document& document) {
    for (const tinygltf::Mesh& mesh : document.model().meshes)
        for (const tinygltf::Primitive& primitive : mesh.primitives)
            if (!primitive.targets.empty()) return true;
    return false;
}

}  // namespace

void reportExtensions(const Document& document, Scene& scene) {
    const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const std::vector<std::string>& required = document.model().extensionsRequired;
    std::vector<std::string> names;
    for (const std::string& name : required)
        if (!isHonoured(name)) document.fail("extensionsRequired: needs {}, which vkpt does not support", name);
    for (const auto* list : {&document.model().extensionsUsed, &required})
        for (const std::string& name : *list)
            if (!holds(names, name)) names.push_back(name);
    for (const std::string& name : names) {
        const bool honoured = isHonoured(name);
        scene.extensions.push_back({name, honoured ? "honoured" : "ignored", holds(required, name)});
        if (!honoured) scene.warnings.push_back(fmt::format("{} is not supported and is ignored", name));
    }

    if (!document.model().animations.empty()) scene.ignored.emplace_back("animations");
    if (!document.model().skins.empty()) scene.ignored.emplace_back("skins");
    if (hasMorphTargets(document)) scene.ignored.emplace_back("morph targets");
    for (const std::string& feature : scene.ignored)
        scene.warnings.push_back(fmt::format("{} are not supported; the scene is shown as it is stored", feature));
}

}  // namespace vkpt::gltf
