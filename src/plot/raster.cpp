// Pixels by coverage: a shape's signed distance at a pixel's centre, as far as it is within half a pixel of the edge.
// Pictures by a box filter: the mean of the texels under a pixel.
#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plot/drawing.h"

namespace vkpt {
namespace {

constexpr double kFontLine = 12;  ///< units of stb_easy_font that a line of text is high
constexpr double kBaseline = 8;   ///< of which lie above the baseline

/// The font has glyphs for printable ASCII and reads beyond its table for others: those become a '?' each.
std::string drawable(const std::string& text) {
    std::string result;
    for (const char c : text) {
        const bool continues = (static_cast<unsigned char>(c) & 0xc0U) == 0x80U;  // a character of UTF-8
        if (!continues) result += c >= ' ' && c <= '~' ? c : '?';
    }
    return result;
}

/// What lies under a pixel along one axis of a picture, in texels.
struct Footprint {
    double low, high;

    Footprint(double pixel, double start, double pixelsPerTexel, double texels)
        : low(std::clamp((pixel - start) / pixelsPerTexel, 0.0, texels)),
          high(std::clamp((pixel + 1 - start) / pixelsPerTexel, 0.0, texels)) {}

    [[nodiscard]] double size() const { return high - low; }
    /// The part of a texel that lies within.
    [[nodiscard]] double of(double texel) const {
        return std::max(0.0, std::min(high, texel + 1) - std::max(low, texel));
    }
};

/// Mean over a footprint that is not empty.
Ink meanUnder(const Image& image, const Footprint& column, const Footprint& row) {
    std::array<double, 3> sum{};
    for (auto y = static_cast<std::uint32_t>(row.low); y < row.high; ++y)
        for (auto x = static_cast<std::uint32_t>(column.low); x < column.high; ++x)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += column.of(x) * row.of(y) * double{image.at(x, y)[c]};
    const auto mean = [&](std::size_t c) { return static_cast<float>(sum[c] / (column.size() * row.size())); };
    return {mean(0), mean(1), mean(2)};
}

class Rasteriser {
public:
    Rasteriser(Image& image, double scale) : image_(image), scale_(scale) {}

    void operator()(const shape::Circle& s) {
        fill(s.x - s.radius, s.y - s.radius, s.x + s.radius, s.y + s.radius, s.ink,
             [&](double x, double y) { return s.radius - std::hypot(x - s.x, y - s.y); });
    }
    void operator()(const shape::Line& s) {
        const double dx = s.x1 - s.x0, dy = s.y1 - s.y0, length2 = dx * dx + dy * dy, half = s.width / 2;
        fill(std::min(s.x0, s.x1) - half, std::min(s.y0, s.y1) - half, std::max(s.x0, s.x1) + half,
             std::max(s.y0, s.y1) + half, s.ink, [&](double x, double y) {
                 const double along = ((x - s.x0) * dx + (y - s.y0) * dy) / length2;
                 const double t = length2 > 0 ? std::clamp(along, 0.0, 1.0) : 0;
                 return half - std::hypot(x - s.x0 - t * dx, y - s.y0 - t * dy);
             });
    }
    void operator()(const shape::Box& s) {
        fill(s.x, s.y, s.x + s.width, s.y + s.height, s.ink, [&](double x, double y) {
            return std::min(std::min(x - s.x, s.x + s.width - x), std::min(y - s.y, s.y + s.height - y));
        });
    }
    void operator()(const shape::Picture& s) {
        const double texel = s.width / s.image.width * scale_, left = s.x * scale_, top = s.y * scale_;
        for (std::uint32_t y = pixel(top, image_.height); y < pixel(top + s.height() * scale_ + 1, image_.height); ++y)
            for (std::uint32_t x = pixel(left, image_.width); x < pixel(left + s.width * scale_ + 1, image_.width);
                 ++x) {
                const Footprint column(x, left, texel, s.image.width), row(y, top, texel, s.image.height);
                const double cover = column.size() * row.size() * texel * texel;
                if (cover > 0) blend(x, y, meanUnder(s.image, column, row), static_cast<float>(cover));
            }
    }
    void operator()(const shape::Text& s) {
        std::string text = drawable(s.text);
        std::vector<std::array<float, 4>> vertices(text.size() * 4 * 70 + 4);
        const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(),
                                              static_cast<int>(vertices.size() * sizeof(vertices[0])));
        const double unit = s.size / kFontLine, width = stb_easy_font_width(text.data()) * unit;
        const double left = s.x - width * (s.align == Align::Left ? 0 : s.align == Align::Middle ? 0.5 : 1);
        for (std::size_t q = 0; q < static_cast<std::size_t>(quads); ++q) {
            const auto &a = vertices[4 * q], &b = vertices[4 * q + 2];  // opposite corners
            (*this)(shape::Box{left + double{a[0]} * unit, s.y + (double{a[1]} - kBaseline) * unit,
                               double{b[0] - a[0]} * unit, double{b[1] - a[1]} * unit, s.ink});
        }
    }

private:
    /// Blends ink over the box by how far inside each pixel's centre is.
    template <class Inside>
    void fill(double x0, double y0, double x1, double y1, const Ink& ink, const Inside& inside) {
        for (std::uint32_t y = pixel(y0 * scale_ - 1, image_.height); y < pixel(y1 * scale_ + 2, image_.height); ++y)
            for (std::uint32_t x = pixel(x0 * scale_ - 1, image_.width); x < pixel(x1 * scale_ + 2, image_.width);
                 ++x) {
                const double distance = inside((x + 0.5) / scale_, (y + 0.5) / scale_) * scale_;
                blend(x, y, ink, static_cast<float>(std::clamp(distance + 0.5, 0.0, 1.0)));
            }
    }

    void blend(std::uint32_t x, std::uint32_t y, const Ink& ink, float cover) {
        float* p = image_.at(x, y);
        p[0] += (ink.r - p[0]) * cover;
        p[1] += (ink.g - p[1]) * cover;
        p[2] += (ink.b - p[2]) * cover;
    }

    static std::uint32_t pixel(double v, std::uint32_t end) {
        return static_cast<std::uint32_t>(std::clamp(v, 0.0, static_cast<double>(end)));
    }

    Image& image_;
    double scale_;
};

}  // namespace

Image toImage(const Drawing& drawing, double scale) {
    Image image(static_cast<std::uint32_t>(std::ceil(drawing.width * scale)),
                static_cast<std::uint32_t>(std::ceil(drawing.height * scale)), 3);
    std::ranges::fill(image.pixels, 1.0F);
    Rasteriser rasteriser(image, scale);
    for (const Shape& s : drawing.shapes) std::visit(rasteriser, s);
    return image;
}

}  // namespace vkpt
