// PNG files within HTML and SVG text.
#pragma once
#include <string>

#include "film/encode.h"

namespace vkpt {

/// `data:image/png;base64,...` of the bytes of a PNG file. [RFC 2397]
[[nodiscard]] std::string pngDataUri(const Bytes& png);

}  // namespace vkpt
