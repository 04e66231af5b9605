// Checked JSON -> tinygltf's model.
#pragma once
#include <optional>
#include <span>

#include "gltf/document.h"

namespace vkpt::gltf {

/// Loads the model with its buffers; images in buffer views keep their encoded bytes, others only their uri. `root` has
/// passed the schema; `bin` is the GLB's binary chunk. Throws FileError where buffers or views lack bytes, or where a
/// type or a camera is none that glTF knows.
[[nodiscard]] tinygltf::Model loadModel(const Document& document, const Json& root,
                                        std::optional<std::span<const unsigned char>> bin);

/// `object[key]` of an extension, or `fallback`.
[[nodiscard]] double numberOr(const tinygltf::Value& object, const std::string& key, double fallback);
/// extensions[name], or a null value.
[[nodiscard]] const tinygltf::Value& extension(const tinygltf::ExtensionMap& extensions, const std::string& name);

}  // namespace vkpt::gltf
