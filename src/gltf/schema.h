// The part of glTF's JSON schema that vkpt reads.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace vkpt::gltf {

/// Checks type, range and presence of every property that the importer reads, and that every index points into its
/// array, so that code after it may read members without further care. Reduces `root` to these properties and makes
/// every number of the kind that its property is of: 3.0 becomes 3 where glTF has an integer.
/// Throws FileError(file, "meshes[0].primitives[2].indices: 7, but the file has 4 accessors").
void checkSchema(nlohmann::json& root, const std::string& file);

}  // namespace vkpt::gltf
