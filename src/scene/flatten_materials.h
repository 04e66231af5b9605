// The material part of flatten.
#pragma once
#include <vector>

#include "scene/flatten_geometry.h"

namespace vkpt {

/// Which materials placed primitives use, and what geometry must know of them.
[[nodiscard]] std::vector<MaterialTraits> materialTraits(const Scene& scene);

/// Fills materials, their BSDFs and albedo tables, textures and texels: each image once, and only those a used material
/// reads.
void flattenMaterials(const Scene& scene, const std::vector<MaterialTraits>& traits, bool multiscatter,
                      SceneArrays& arrays);

/// The material's BSDF model; an unlit one has glTF's.
[[nodiscard]] BsdfId bsdfModel(const Material& material);

/// An image slot reads something: the image exists and has texels.
[[nodiscard]] bool hasImage(const Scene& scene, const TextureUse& use);

}  // namespace vkpt
