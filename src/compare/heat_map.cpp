#include "compare/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include "base/draw.h"
#include "compare/channels.h"
#include "compare/false_color.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kLeastWidth = 256;  // room for six numbers at text scale 1
constexpr double kShareAboveTop = 0.005;
const glm::vec3 kInk{0.9F}, kPaper{0.08F}, kNotFinite{0, 1, 1};

/// Where the parts of the picture are, in pixels. `text`: the scale of the font.
struct Layout {
    std::int64_t width, pictureHeight, text, left, barWidth, titleTop, barTop, barHeight, numbersTop, height;

    Layout(std::int64_t pictureWidth, std::int64_t imageHeight)
        : width(pictureWidth), pictureHeight(imageHeight), text(std::max<std::int64_t>(1, pictureWidth / 480)) {
        left = 12 * text;
        barWidth = width - 2 * left;
        titleTop = pictureHeight + 5 * text;
        barTop = titleTop + (kGlyphHeight + 4) * text;
        barHeight = 10 * text;
        numbersTop = barTop + barHeight + 6 * text;
        height = numbersTop + (kGlyphHeight + 4) * text;
    }
};

glm::vec3 colorOf(float value, double top) {
    return std::isnan(value) ? kNotFinite : falseColor(static_cast<float>(value / top));
}

void drawPicture(Image& picture, const Image& values, std::uint32_t enlarge, double top) {
    for (std::uint32_t y = 0; y < values.height * enlarge; ++y) {
        for (std::uint32_t x = 0; x < values.width * enlarge; ++x) {
            const glm::vec3 color = colorOf(*values.at(x / enlarge, y / enlarge), top);
            std::copy_n(&color.x, 3, picture.at(x, y));
        }
    }
}

/// "0.2" for the tick, ">0.2" at the end of a scale that some values exceed.
std::string tickText(double value, bool exceeded) { return fmt::format("{}{:.3g}", exceeded ? ">" : "", value); }

void drawScale(Image& picture, const Layout& at, double top, double largest) {
    for (std::int64_t x = 0; x < at.barWidth; ++x) {
        const float t = static_cast<float>(x) / static_cast<float>(std::max<std::int64_t>(1, at.barWidth - 1));
        fillRectangle(picture, at.left + x, at.barTop, 1, at.barHeight, falseColor(t));
    }
    const double lead = top / std::pow(10.0, std::floor(std::log10(top * 1.0001)));  // 1, 2 or 5 in scales of our own
    const int steps = std::abs(lead - 2) < 0.01 ? 4 : 5;
    for (int i = 0; i <= steps; ++i) {
        const std::int64_t x = at.left + (at.barWidth - 1) * i / steps;
        fillRectangle(picture, x, at.barTop + at.barHeight, at.text, 3 * at.text, kInk);
        const std::string text = tickText(top * i / steps, i == steps && largest > top);
        const std::int64_t half = textWidth(text, at.text) / 2;
        drawText(picture, std::clamp(x - half, at.text, at.width - 2 * half - at.text), at.numbersTop, text, kInk,
                 at.text);
    }
}

bool anyNan(const Image& values) {
    return std::any_of(values.pixels.begin(), values.pixels.end(), [](float v) { return std::isnan(v); });
}

double largestOf(const Image& values) {
    double largest = 0;
    for (const float v : values.pixels)
        if (v > largest) largest = v;
    return largest;
}

}  // namespace

Image absoluteDifference(const Image& image, const Image& reference) {
    const std::vector<ChannelPair> pairs = pairChannels(image, reference);
    Image result(image.width, image.height, 1);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            float largest = 0;
            for (const ChannelPair& pair : pairs) {
                const float a = image.at(x, y)[pair.image], r = reference.at(x, y)[pair.reference];
                if (a == r || (std::isnan(a) && std::isnan(r))) continue;
                const float difference = std::abs(a - r);
                largest = std::isfinite(difference) && !std::isnan(largest) ? std::max(largest, difference)
                                                                            : std::numeric_limits<float>::quiet_NaN();
            }
            *result.at(x, y) = largest;
        }
    }
    return result;
}

double scaleTop(const Image& values) {
    assert(values.channels == 1);
    std::vector<float> positive;
    std::copy_if(values.pixels.begin(), values.pixels.end(), std::back_inserter(positive),
                 [](float v) { return v > 0 && std::isfinite(v); });
    if (positive.empty()) return 1;
    // Zeros count too: the quantile is over all pixels, but never below the smallest positive value.
    const auto above = static_cast<std::size_t>(kShareAboveTop * static_cast<double>(values.pixels.size()));
    const std::size_t rank = above < positive.size() ? positive.size() - 1 - above : 0;
    std::nth_element(positive.begin(), positive.begin() + static_cast<std::ptrdiff_t>(rank), positive.end());
    const double value = positive[rank];
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * decade * (1 + 1e-6)) return step * decade;
    return 10 * decade;
}

Image heatMap(const Image& values, const HeatMapOptions& options) {
    assert(values.channels == 1 && values.width > 0);
    const double top = options.top > 0 ? options.top : scaleTop(values);
    const std::uint32_t enlarge = (kLeastWidth + values.width - 1) / values.width;
    const Layout at(std::int64_t{values.width} * enlarge, std::int64_t{values.height} * enlarge);
    Image picture(static_cast<std::uint32_t>(at.width), static_cast<std::uint32_t>(at.height), 3);
    picture.displayEncoded = true;
    fillRectangle(picture, 0, 0, at.width, at.height, kPaper);
    drawPicture(picture, values, enlarge, top);
    drawText(picture, at.left, at.titleTop, options.title, kInk, at.text);
    if (anyNan(values))
        drawText(picture, at.left + textWidth(options.title + "  ", at.text), at.titleTop, "NOT FINITE", kNotFinite,
                 at.text);
    drawScale(picture, at, top, largestOf(values));
    return picture;
}

}  // namespace vkpt
