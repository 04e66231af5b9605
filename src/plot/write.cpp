#include "plot/write.h"

#include <algorithm>
#include <cctype>
#include <span>

#include "base/atomic_file.h"
#include "film/encode.h"

namespace vkpt {
namespace {

std::string extensionOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

}  // namespace

bool isDrawingFile(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    return extension == ".png" || extension == ".svg";
}

void writeDrawing(const std::filesystem::path& path, const Drawing& drawing) {
    if (extensionOf(path) == ".svg") {
        const std::string svg = toSvg(drawing);
        return writeFileAtomically(path, std::as_bytes(std::span(svg)));
    }
    writeFileAtomically(path, encodePng(toImage(drawing), 8, {}));
}

}  // namespace vkpt
