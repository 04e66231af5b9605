// JSON as the commands write it: keys in the order they were given.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace vkpt {

using Json = nlohmann::ordered_json;

/// Pretty-printed. Bytes that are no UTF-8, as in some file names, become replacement characters.
/// `indent` -1: on one line.
[[nodiscard]] std::string jsonText(const Json& json, int indent = 2);

/// jsonText, written whole or not at all. Throws FileError.
void writeJsonFile(const std::filesystem::path& path, const Json& json);

}  // namespace vkpt
