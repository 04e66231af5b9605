// Reads images of any kind vkpt knows into floats.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/image.h"

namespace vkpt {

/// Reads an image; its kind is told by its contents, not its name. Row 0 of the result is the top.
///   Radiance .hdr   3 channels, any orientation, flat or run-length coded; EXPOSURE is not undone (nor is it
///   elsewhere) OpenEXR         the display window of the first part: RGB, RGBA, Y, YA, or one channel of any name;
///   luminance and
///                   chroma files as RGB; pixels outside the data window are 0
///   .pfm            1 or 3 channels
///   .png            3 or 4 channels, still display-encoded, value / 255 or / 65535
/// Values are as stored: negative and non-finite ones too. Throws FileError for what is missing, broken, or of no kind
/// above. Memory in use stays in proportion to the file's own size.
[[nodiscard]] Image readImage(const std::filesystem::path& file);

/// The same of bytes in memory, which errors call `name`.
[[nodiscard]] Image decodeImage(const std::string& name, std::span<const std::uint8_t> bytes);

}  // namespace vkpt
