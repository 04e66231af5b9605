// Checked JSON -> tinygltf's model.
#pragma once
#include "gltf/document.h"

namespace vkpt::gltf {

/// type or componentType of an accessor that is none of glTF 2.0's.
inline constexpr int kUnknown = -1;

/// The model without any bytes: buffers and images are the document's own. `root` has passed the schema.
[[nodiscard]] tinygltf::Model loadModel(const Document& document, const Json& root);

/// `object[key]` of an extension, or `fallback`.
[[nodiscard]] double numberOr(const tinygltf::Value& object, const std::string& key, double fallback);
/// extensions[name], or a null value.
[[nodiscard]] const tinygltf::Value& extension(const tinygltf::ExtensionMap& extensions, const std::string& name);

}  // namespace vkpt::gltf
