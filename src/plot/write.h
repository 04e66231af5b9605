// A drawing to a file.
#pragma once
#include <filesystem>
#include <string_view>

#include "plot/drawing.h"

namespace vkpt {

inline constexpr std::string_view kDrawingExtensions = ".png .svg";

/// Whether the extension is one of kDrawingExtensions, whatever its case.
[[nodiscard]] bool isDrawingFile(const std::filesystem::path& path);

/// The file appears whole or not at all. Throws FileError.
void writeDrawing(const std::filesystem::path& path, const Drawing& drawing);

}  // namespace vkpt
