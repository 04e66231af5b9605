// Materials of a glTF file and the images they use.
#pragma once
#include <cstdint>
#include <vector>

#include "gltf/document.h"
#include "scene/scene.h"

namespace vkpt::gltf {

/// Reads materials[index]. TextureUse::image still counts the file's images. Nothing is decoded.
/// Slots whose texture vkpt cannot read stay empty and say so in `warnings`.
[[nodiscard]] Material readMaterial(const Document& document, std::size_t index, std::vector<std::string>& warnings);

/// The file's images that `materials` use, in the file's order; renumbers every TextureUse::image to fit.
[[nodiscard]] std::vector<std::size_t> collectImages(const Document& document, std::vector<Material>& materials);

}  // namespace vkpt::gltf
