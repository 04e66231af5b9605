#include <fmt/format.h>

#include <array>

#include "film/data_uri.h"
#include "plot/drawing.h"

namespace vkpt {
namespace {

std::string hex(const Ink& ink) {
    const auto byte = [](float v) { return static_cast<int>(v * 255 + 0.5F); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(ink.r), byte(ink.g), byte(ink.b));
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else
            result += c;
    }
    return result;
}

struct SvgWriter {
    std::string operator()(const shape::Circle& s) const {
        return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"/>\n", s.x, s.y, s.radius,
                           hex(s.ink));
    }
    std::string operator()(const shape::Line& s) const {
        return fmt::format(
            "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke-width=\"{:.2f}\" "
            "stroke=\"{}\" stroke-linecap=\"round\"/>\n",
            s.x0, s.y0, s.x1, s.y1, s.width, hex(s.ink));
    }
    std::string operator()(const shape::Box& s) const {
        return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", s.x,
                           s.y, s.width, s.height, hex(s.ink));
    }
    std::string operator()(const shape::Picture& s) const {
        return fmt::format(
            "<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" preserveAspectRatio=\"none\" "
            "style=\"image-rendering:pixelated\" href=\"{}\"/>\n",
            s.x, s.y, s.width, s.height(), pngDataUri(encodePng(s.image, 8, {})));
    }
    std::string operator()(const shape::Text& s) const {
        static constexpr std::array kAnchors{"start", "middle", "end"};
        return fmt::format(
            "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.1f}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n", s.x, s.y,
            s.size, kAnchors.at(static_cast<std::size_t>(s.align)), hex(s.ink), escaped(s.text));
    }
};

}  // namespace

Ink inkOf(std::size_t n) {
    static constexpr std::array<Ink, 8> kInks{{{0.00F, 0.45F, 0.70F},
                                               {0.84F, 0.37F, 0.00F},
                                               {0.00F, 0.62F, 0.45F},
                                               {0.80F, 0.47F, 0.65F},
                                               {0.90F, 0.62F, 0.00F},
                                               {0.34F, 0.71F, 0.91F},
                                               {0.35F, 0.35F, 0.38F},
                                               {0.60F, 0.30F, 0.15F}}};
    return kInks[n % kInks.size()];
}

void Drawing::frame(double x, double y, double w, double h, double lineWidth, Ink ink) {
    line(x, y, x + w, y, lineWidth, ink);
    line(x + w, y, x + w, y + h, lineWidth, ink);
    line(x + w, y + h, x, y + h, lineWidth, ink);
    line(x, y + h, x, y, lineWidth, ink);
}

std::string toSvg(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" "
        "font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        drawing.width, drawing.height);
    for (const Shape& s : drawing.shapes) svg += std::visit(SvgWriter{}, s);
    return svg + "</svg>\n";
}

}  // namespace vkpt
