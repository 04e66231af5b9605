#include "plot/drawing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "base/image_read.h"
#include "plot/chart.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

Image noise(std::uint32_t width, std::uint32_t height) {
    Image image(width, height, 3);
    std::mt19937 generator(7);
    for (float& value : image.pixels) value = static_cast<float>(generator() % 256) / 255;
    return image;
}

/// The image that an SVG embeds: the inverse of base64 [RFC 4648], digit by digit.
Image embedded(const std::string& svg) {
    static const std::string kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/",
                             kBefore = "href=\"data:image/png;base64,";
    const std::size_t first = svg.find(kBefore) + kBefore.size();
    const std::string text = svg.substr(first, svg.find('"', first) - first);
    EXPECT_EQ(text.size() % 4, 0U);
    std::vector<std::uint8_t> bytes;
    std::uint32_t bits = 0, count = 0;
    for (const char c : text.substr(0, text.find('='))) {
        bits = bits << 6U | static_cast<std::uint32_t>(kDigits.find(c));
        if ((count += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
    }
    EXPECT_EQ(bytes.size(), text.size() / 4 * 3 - std::count(text.begin(), text.end(), '='));
    return decodeImage("embedded", bytes);
}

float brightness(const Image& image, std::uint32_t x, std::uint32_t y) { return image.at(x, y)[0]; }

TEST(ToImage, CoversWhatTheShapeCovers) {
    Drawing d{20, 10, {}};
    d.box(2, 2, 4, 4, {0, 0, 0});
    d.circle(14, 5, 3, {0, 0, 0});
    const Image image = toImage(d, 1);
    ASSERT_EQ(image.width, 20U);
    double dark = 0;
    for (std::uint32_t y = 0; y < 10; ++y)
        for (std::uint32_t x = 0; x < 20; ++x) dark += 1 - brightness(image, x, y);
    EXPECT_NEAR(dark, 16 + 9 * 3.14159, 1.5);
    EXPECT_EQ(brightness(image, 0, 0), 1);
    EXPECT_EQ(brightness(image, 4, 4), 0);
}

TEST(ToImage, ShowsATexelAsASquare) {
    const Image texels = noise(4, 3);
    Drawing d{16, 12, {}};
    d.picture(3, 2, 8, texels);
    const Image image = toImage(d, 2);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const bool inside = x >= 6 && x < 22 && y >= 4 && y < 16;
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.at(x, y)[c], inside ? texels.at((x - 6) / 4, (y - 4) / 4)[c] : 1, 1e-6)
                    << x << ' ' << y;
        }
}

// A pixel shows the mean of what lies under it, also where that is a part of a texel or of the paper.
TEST(ToImage, ShrinksPicturesByTheirMean) {
    const Image texels = noise(9, 6);
    Drawing d{8, 6, {}};
    d.picture(1.3, 1.6, 4.1, texels);
    const Image image = toImage(d, 1);
    const double area = (4.1 / 9) * (4.1 / 9);
    double dark = 0, expected = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) dark += 1 - double{image.pixels[i]};
    for (std::size_t i = 0; i < texels.pixels.size(); i += 3) expected += area * (1 - double{texels.pixels[i]});
    EXPECT_NEAR(dark, expected, 1e-5);

    Drawing half{4, 3, {}};
    half.picture(0, 0, 4, noise(8, 6));
    const Image halved = toImage(half, 1), whole = noise(8, 6);
    for (std::uint32_t x = 0; x < 4; ++x)
        EXPECT_NEAR(
            brightness(halved, x, 1),
            (whole.at(2 * x, 2)[0] + whole.at(2 * x + 1, 2)[0] + whole.at(2 * x, 3)[0] + whole.at(2 * x + 1, 3)[0]) / 4,
            1e-6);
}

TEST(ToImage, LeavesOutWhatIsOffTheDrawing) {
    Drawing d{4, 4, {}};
    d.picture(-2, -2, 8, noise(4, 4));
    const Image image = toImage(d, 1), texels = noise(4, 4);
    EXPECT_NEAR(brightness(image, 0, 0), texels.at(1, 1)[0], 1e-6);
    EXPECT_NEAR(brightness(image, 3, 3), texels.at(2, 2)[0], 1e-6);
}

TEST(ToImage, DrawsTextWhereItIsAligned) {
    Drawing d{100, 20, {}};
    d.text(100, 14, "abc", 12, Align::Right);
    const Image image = toImage(d, 1);
    double left = 0, right = 0;
    for (std::uint32_t y = 0; y < 20; ++y)
        for (std::uint32_t x = 0; x < 100; ++x) (x < 70 ? left : right) += 1 - brightness(image, x, y);
    EXPECT_EQ(left, 0);
    EXPECT_GT(right, 10);
}

TEST(ToImage, CharactersWithoutAGlyphAreQuestionMarks) {
    const auto drawn = [](const std::string& text) {
        Drawing d{100, 20, {}};
        d.text(2, 14, text);
        return toImage(d, 1).pixels;
    };
    EXPECT_EQ(drawn("\u00fc-\u2600\U0001f4a1"), drawn("?-??"));
    EXPECT_EQ(drawn("a\x7f\n~"), drawn("a??~"));
}

TEST(ToSvg, HoldsEveryShapeAndEscapesText) {
    Drawing d{50, 40, {}};
    d.line(1, 2, 3, 4, 1, kBlack);
    d.text(5, 6, "a < b & c");
    const std::string svg = toSvg(d);
    EXPECT_THAT(svg, HasSubstr("viewBox=\"0 0 50 40\""));
    EXPECT_THAT(svg, HasSubstr("<line x1=\"1.00\""));
    EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
}

// PNG files of many lengths: every padding of base64 is among them.
TEST(ToSvg, EmbedsTheTexelsOfAPicture) {
    for (std::uint32_t width = 1; width < 13; ++width) {
        const Image texels = noise(width, 3);
        Drawing d{50, 40, {}};
        d.picture(5, 6, 2.5 * width, texels);
        const std::string svg = toSvg(d);
        EXPECT_THAT(
            svg, HasSubstr(fmt::format("<image x=\"5.00\" y=\"6.00\" width=\"{:.2f}\" height=\"7.50\"", 2.5 * width)));
        EXPECT_THAT(svg, HasSubstr("image-rendering:pixelated"));
        const Image read = embedded(svg);
        ASSERT_EQ(read.width, width);
        ASSERT_EQ(read.height, 3U);
        for (std::uint32_t y = 0; y < 3; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(read.at(x, y)[c], texels.at(x, y)[c], 1e-6);
    }
}

TEST(Chart, LeavesOutWhatALogarithmCannotHold) {
    Drawing d{400, 300, {}};
    drawChart(d, {50, 30, 200, 200, true, "title", "x", "y"}, {{"curve", {{1, 1}, {10, 0}, {100, 0.01}}}});
    std::size_t circles = 0;
    for (const Shape& s : d.shapes) circles += std::holds_alternative<shape::Circle>(s) ? 1 : 0;
    EXPECT_EQ(circles, 2U);
    EXPECT_THAT(toSvg(d), HasSubstr("1e2"));
}

}  // namespace
}  // namespace vkpt
