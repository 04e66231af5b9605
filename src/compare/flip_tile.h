// FLIP of a part of an image.
#pragma once
#include "base/image.h"
#include "compare/flip_display.h"
#include "compare/flip_filters.h"
#include "compare/tiles.h"

namespace vkpt {

/// Raises each pixel of `map` in the tile to the error that is seen under `display`, 0 to 1. `image` and `reference`
/// hold linear light, of three channels, or of one that is shown as grey; their sizes and that of `map` are equal.
void raiseToFlip(const Image& image, const Image& reference, const Tile& tile, const FlipFilters& filters,
                 const FlipDisplay& display, Image& map);

}  // namespace vkpt
