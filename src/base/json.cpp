#include "base/json.h"

#include "base/atomic_file.h"

namespace vkpt {

std::string jsonText(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace) + (indent < 0 ? "" : "\n");
}

void writeJsonFile(const std::filesystem::path& path, const Json& json) {
    const std::string text = jsonText(json);
    writeFileAtomically(path, std::as_bytes(std::span(text)));
}

}  // namespace vkpt
