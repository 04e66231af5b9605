#include "base/json.h"

#include "base/atomic_file.h"

namespace vkpt {

void writeJsonFile(const std::filesystem::path& path, const Json& json) {
    const std::string text = json.dump(2) + "\n";
    writeFileAtomically(path, std::as_bytes(std::span(text)));
}

}  // namespace vkpt
