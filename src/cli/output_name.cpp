#include "cli/output_name.h"

namespace vkpt {

std::filesystem::path defaultOutput(const std::filesystem::path& scene) {
    std::filesystem::path name = scene.stem();
    if (name == "scene" || name == "model") {
        const std::filesystem::path folder =
            std::filesystem::absolute(scene).lexically_normal().parent_path().filename();
        if (!folder.empty()) name = folder;
    }
    name += ".png";
    return name;
}

}  // namespace vkpt
