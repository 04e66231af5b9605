// Many small pictures on one, each under its name.
#pragma once
#include <string>
#include <vector>

#include "film/light_images.h"
#include "film/tonemap.h"

namespace vkpt {

/// Layers of light, labelled with their shares, and their sum, all under one exposure. Images are shrunk or enlarged by
/// a whole factor, to 480 pixels a side at most. The result has three display-encoded channels: hand it to encodePng as it is.
[[nodiscard]] Image contactSheet(const std::vector<LightImage>& layers, const Image& sum, const Display& display);

}  // namespace vkpt
