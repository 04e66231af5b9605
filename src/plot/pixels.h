// Pictures within drawings.
#pragma once
#include "base/image.h"
#include "plot/drawing.h"

namespace vkpt {

/// Draws an image of three display-encoded channels, `width` wide, as boxes: a run of one colour is one box.
void drawImage(Drawing& drawing, const Image& image, double x, double y, double width);

}  // namespace vkpt
