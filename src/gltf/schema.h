// The part of glTF's JSON schema that vkpt reads.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace vkpt::gltf {

/// Checks type, range and presence of every property that the importer reads, and that every index points into its
/// array, so that code after it may read members without further care. Unknown properties are left alone.
/// Throws FileError(file, "meshes[0].primitives[2].indices: 7, but the file has 4 accessors").
void checkSchema(const nlohmann::json& root, const std::string& file);

}  // namespace vkpt::gltf
