// Simple pictures: a list of shapes that becomes SVG text or pixels.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/image.h"

namespace vkpt {

/// Display values, 0 to 1.
struct Ink {
    float r = 0, g = 0, b = 0;
};
inline constexpr Ink kBlack{0.13F, 0.13F, 0.15F}, kGrey{0.55F, 0.55F, 0.58F}, kPale{0.87F, 0.87F, 0.89F},
    kWhite{1, 1, 1};

/// The n-th of a cycle of colours that are told apart by most eyes. [Okabe 08]
[[nodiscard]] Ink inkOf(std::size_t n);

enum class Align : std::uint8_t { Left, Middle, Right };

namespace shape {
struct Circle {
    double x, y, radius;
    Ink ink;
};
struct Line {
    double x0, y0, x1, y1, width;
    Ink ink;
};
struct Box {
    double x, y, width, height;
    Ink ink;
};
/// Display values in [0, 1], three channels.
struct Picture {
    double x, y, width;  ///< texels are squares of width / image.width units
    Image image;

    [[nodiscard]] double height() const { return width * image.height / image.width; }
};
struct Text {
    double x, y;  ///< on the baseline
    std::string text;
    double size;  ///< height of a line of text
    Align align;
    Ink ink;
};
}  // namespace shape

using Shape = std::variant<shape::Circle, shape::Line, shape::Box, shape::Picture, shape::Text>;

/// Units are pixels of a screen, y down. Later shapes cover earlier ones.
struct Drawing {
    double width = 0, height = 0;
    std::vector<Shape> shapes;

    void circle(double x, double y, double radius, Ink ink) { shapes.emplace_back(shape::Circle{x, y, radius, ink}); }
    void line(double x0, double y0, double x1, double y1, double lineWidth, Ink ink) {
        shapes.emplace_back(shape::Line{x0, y0, x1, y1, lineWidth, ink});
    }
    void box(double x, double y, double w, double h, Ink ink) { shapes.emplace_back(shape::Box{x, y, w, h, ink}); }
    void frame(double x, double y, double w, double h, double lineWidth, Ink ink);
    void picture(double x, double y, double w, Image image) {
        shapes.emplace_back(shape::Picture{x, y, w, std::move(image)});
    }
    void text(double x, double y, std::string words, double size = 12, Align align = Align::Left, Ink ink = kBlack) {
        shapes.emplace_back(shape::Text{x, y, std::move(words), size, align, ink});
    }
};

/// Pictures are embedded as PNG, their texels shown as squares.
[[nodiscard]] std::string toSvg(const Drawing& drawing);

/// `scale` pixels a unit, antialiased, on white; pictures by a box filter. Text is drawn in the font of stb_easy_font,
/// which is ASCII only: other characters are a '?' each.
[[nodiscard]] Image toImage(const Drawing& drawing, double scale = 2);

}  // namespace vkpt
