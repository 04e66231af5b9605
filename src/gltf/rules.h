// What the specification demands of a document beyond the types and ranges of its properties.
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vkpt::gltf {

/// Checks how properties go together; `root` has passed the schema. Returns warnings, one line each, about slips that
/// leave no doubt of what is meant: an extension used without being declared, or declared twice.
/// Throws FileError(file, "nodes[2]: has a matrix and a translation").
[[nodiscard]] std::vector<std::string> checkRules(const nlohmann::json& root, const std::string& file);

}  // namespace vkpt::gltf
