#include "base/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/font.h"

namespace vkpt {
namespace {

/// The image as text: '#' where it is red.
std::string rows(const Image& image) {
    std::string text;
    for (std::uint32_t y = 0; y < image.height; ++y, text += '\n')
        for (std::uint32_t x = 0; x < image.width; ++x) text += image.at(x, y)[0] > 0 ? '#' : '.';
    return text;
}

std::string drawn(std::string_view text, std::uint32_t width, std::uint32_t height, std::int64_t scale = 1) {
    Image image(width, height, 3);
    drawText(image, 0, 0, text, glm::vec3(1), scale);
    return rows(image);
}

TEST(Draw, TextIsMadeOfItsGlyphs) {
    EXPECT_EQ(drawn("1.", 11, 7),
              "..#........\n.##........\n#.#........\n..#........\n..#........\n..#....##..\n#####..##..\n");
    EXPECT_EQ(textWidth("1.", 1), 11);
    EXPECT_EQ(textWidth("1.", 3), 33);
    EXPECT_EQ(textWidth("", 3), 0);
}

TEST(Draw, ScaleEnlargesEachPixel) {
    const std::string small = drawn("F", 5, 7), large = drawn("F", 10, 14, 2);
    for (std::size_t y = 0; y < 14; ++y)
        for (std::size_t x = 0; x < 10; ++x) EXPECT_EQ(large[y * 11 + x], small[y / 2 * 6 + x / 2]);
}

TEST(Draw, LettersAreCapitalsAndTheUnknownIsABox) {
    EXPECT_EQ(drawn("relmse", 35, 7), drawn("RELMSE", 35, 7));
    EXPECT_EQ(drawn("~", 5, 7), "#####\n#...#\n#...#\n#...#\n#...#\n#...#\n#####\n");
}

TEST(Draw, WhatLiesOutsideIsLeftOut) {
    Image image(3, 2, 3);
    fillRectangle(image, -5, 1, 7, 100, glm::vec3(1, 0, 0));
    EXPECT_EQ(rows(image), "...\n##.\n");
    EXPECT_EQ(image.at(0, 1)[1], 0);
    drawText(image, 2, -3, "88", glm::vec3(1), 1);  // must not write past the ends
    fillRectangle(image, 5, 5, 3, 3, glm::vec3(1));
}

TEST(Draw, EveryGlyphIsDistinct) {
    std::set<std::array<std::uint8_t, 7>> shapes{kUnknownGlyph.rows};
    for (const Glyph& glyph : kFont) EXPECT_TRUE(shapes.insert(glyph.rows).second) << glyph.character;
    for (const char needed : std::string("0123456789.-+E>%"))
        EXPECT_TRUE(std::any_of(kFont.begin(), kFont.end(), [&](const Glyph& g) { return g.character == needed; }));
}

}  // namespace
}  // namespace vkpt
