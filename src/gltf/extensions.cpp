#include "gltf/extensions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace vkpt::gltf {
namespace {

constexpr std::array<std::string_view, 5> kHonoured = {"KHR_lights_punctual", "KHR_materials_emissive_strength",
                                                       "KHR_materials_unlit", "KHR_mesh_quantization",
                                                       "KHR_texture_transform"};

bool isHonoured(std::string_view name) {
    return std::find(kHonoured.begin(), kHonoured.end(), name) != kHonoured.end();
}

bool hasMorphTargets(const Document& document) {
    for (std::size_t i = 0; i < document.count("meshes"); ++i)
        for (const Json& primitive : member(document.item("meshes", i), "primitives"))
            if (!member(primitive, "targets").empty()) return true;
    return false;
}

}  // namespace

void reportExtensions(const Document& document, Scene& scene) {
    const Json& required = member(document.root(), "extensionsRequired");
    const auto isRequired = [&](const std::string& name) {
        return std::find(required.begin(), required.end(), name) != required.end();
    };
    std::vector<std::string> names = member(document.root(), "extensionsUsed").is_null()
                                         ? std::vector<std::string>()
                                         : member(document.root(), "extensionsUsed").get<std::vector<std::string>>();
    for (const Json& name : required) {
        if (!isHonoured(name.get_ref<const std::string&>()))
            document.fail("extensionsRequired: needs {}, which vkpt does not support", name.get<std::string>());
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name.get<std::string>());
    }
    for (const std::string& name : names) {
        const bool honoured = isHonoured(name);
        scene.extensions.push_back({name, honoured ? "honoured" : "ignored", isRequired(name)});
        if (!honoured) scene.warnings.push_back(fmt::format("{} is not supported and is ignored", name));
    }

    if (document.count("animations") > 0) scene.ignored.emplace_back("animations");
    if (document.count("skins") > 0) scene.ignored.emplace_back("skins");
    if (hasMorphTargets(document)) scene.ignored.emplace_back("morph targets");
    for (const std::string& feature : scene.ignored)
        scene.warnings.push_back(fmt::format("{} are not supported; the scene is shown as it is stored", feature));
}

}  // namespace vkpt::gltf
