// JSON as the commands write it: keys in the order they were given.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

namespace vkpt {

using Json = nlohmann::ordered_json;

/// Pretty-printed, written whole or not at all. Throws FileError.
void writeJsonFile(const std::filesystem::path& path, const Json& json);

}  // namespace vkpt
