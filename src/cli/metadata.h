// What a picture says about its making.
#pragma once
#include <string>

#include "base/json.h"
#include "cli/backend.h"
#include "cli/scene_setup.h"
#include "film/write_image.h"

namespace vkpt {

/// Every option that alters radiance, resolved: the camera as vectors, names instead of defaults. The sample range
/// is no part of it, so that ranges of one render state the same settings.
[[nodiscard]] Json renderSettings(const PreparedScene& prepared);

/// 16 hexadecimal digits: FNV-1a over the scene file, the buffers and images it refers to, the environment's file
/// and the text of renderSettings. Equal hashes: pictures of the same thing, whose sample ranges may be merged.
[[nodiscard]] std::string settingsHash(const PreparedScene& prepared);

/// Key and value, in the order they are stored: what was rendered, by what, with which samples.
[[nodiscard]] ImageMetadata imageMetadata(const PreparedScene& prepared, const RenderReport& report, const Film& film);

}  // namespace vkpt
