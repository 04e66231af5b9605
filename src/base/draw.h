// Rectangles and words on an image: scales and labels of the pictures that commands make.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

#include "base/image.h"

namespace vkpt {

inline constexpr std::int64_t kGlyphHeight = 7;   ///< of text at scale 1, in pixels
inline constexpr std::int64_t kGlyphAdvance = 6;  ///< from one character to the next

/// Pixels from the left edge of the first character to the right edge of the last.
[[nodiscard]] std::int64_t textWidth(std::string_view text, std::int64_t scale);

/// Writes `text` with its top left corner at (x, y). Letters appear as capitals; a character that the font lacks
/// appears as a box. What lies outside the image is left out. The image has at least three channels.
void drawText(Image& image, std::int64_t x, std::int64_t y, std::string_view text, const glm::vec3& color,
              std::int64_t scale);

/// Fills the part of the rectangle that lies in the image, which has at least three channels.
void fillRectangle(Image& image, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height,
                   const glm::vec3& color);

}  // namespace vkpt
