// What a picture says about its making.
#pragma once
#include "base/json.h"
#include "cli/scene_setup.h"
#include "film/encode.h"
#include "film/film_record.h"

namespace vkpt {

/// Every option that alters the image, resolved: the camera as vectors, names instead of defaults, hashes of what the
/// scene holds. The sample range is no part of it, so that ranges of one render state the same settings; nor is what
/// computes them.
[[nodiscard]] Json renderSettings(const PreparedScene& prepared);

/// Key and value, in the order they are stored: what was rendered, by what, with which samples.
[[nodiscard]] ImageMetadata imageMetadata(const FilmRecord& record);

}  // namespace vkpt
