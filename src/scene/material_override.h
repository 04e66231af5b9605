// Another BSDF for a material: by VKPT_materials_bsdf or from the command line.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace vkpt {

/// Gives a material the spec's model. Of glTF's own it sets the factors. Textures stay, and multiply; `unlit` ends.
void setBsdf(Material& material, const BsdfSpec& spec);

/// "NAME=SPEC" or "INDEX=SPEC". Throws Error(Usage) where the scene has no such material, naming those it has, or the
/// spec is faulty.
void overrideMaterial(std::vector<Material>& materials, const std::string& text);

/// One SPEC for all materials. Throws as above.
void overrideMaterials(std::vector<Material>& materials, const std::string& spec);

}  // namespace vkpt
