#include "base/draw.h"

#include <algorithm>
#include <cassert>
#include <cctype>

#include "base/font.h"

namespace vkpt {
namespace {

constexpr int kGlyphColumns = 5;

const Glyph& glyphOf(char character) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    const auto* found =
        std::find_if(kFont.begin(), kFont.end(), [&](const Glyph& g) { return g.character == capital; });
    return found == kFont.end() ? kUnknownGlyph : *found;
}

}  // namespace

std::int64_t textWidth(std::string_view text, std::int64_t scale) {
    const auto count = static_cast<std::int64_t>(text.size());
    return count == 0 ? 0 : (count * kGlyphAdvance - (kGlyphAdvance - kGlyphColumns)) * scale;
}

void fillRectangle(Image& image, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height,
                   const glm::vec3& color) {
    assert(image.channels >= 3);
    const std::int64_t right = std::min<std::int64_t>(x + width, image.width);
    const std::int64_t bottom = std::min<std::int64_t>(y + height, image.height);
    for (std::int64_t row = std::max<std::int64_t>(y, 0); row < bottom; ++row)
        for (std::int64_t column = std::max<std::int64_t>(x, 0); column < right; ++column)
            for (int c = 0; c < 3; ++c)
                image.at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row))[c] = color[c];
}

void drawText(Image& image, std::int64_t x, std::int64_t y, std::string_view text, const glm::vec3& color,
              std::int64_t scale) {
    for (const char character : text) {
        const Glyph& glyph = glyphOf(character);
        for (std::int64_t row = 0; row < kGlyphHeight; ++row)
            for (std::int64_t column = 0; column < kGlyphColumns; ++column)
                if ((glyph.rows[static_cast<std::size_t>(row)] >> (kGlyphColumns - 1 - column) & 1) != 0)
                    fillRectangle(image, x + column * scale, y + row * scale, scale, scale, color);
        x += kGlyphAdvance * scale;
    }
}

}  // namespace vkpt
