#include "plot/drawing.h"

#include <gmock/gmock.h>

#include "plot/chart.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

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
