// The name of a picture nobody named.
#pragma once
#include <filesystem>

namespace vkpt {

/// NAME.png in the caller's folder: NAME is the scene's stem, or its folder's name where the stem is `scene` or
/// `model`.
[[nodiscard]] std::filesystem::path defaultOutput(const std::filesystem::path& scene);

}  // namespace vkpt
