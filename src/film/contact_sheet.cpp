#include "film/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/draw.h"

namespace vkpt {
namespace {

constexpr glm::vec3 kSheetPaper{1, 1, 1}, kSheetInk{0.1F, 0.1F, 0.12F}, kShareInk{0.4F, 0.4F, 0.44F};
constexpr std::int64_t kGap = 12, kTextScale = 2, kLine = (kGlyphHeight + 3) * kTextScale, kLabel = 2 * kLine + 4;
constexpr std::uint32_t kLeastTile = 240, kMostTile = 480, kManyTiles = 16, kSmallTile = 320;
constexpr double kSheetAspect = 1.6;

/// The mean of whole blocks of pixels, or copies of each, as RGBA. What is left of the last blocks is left out.
Image resized(const Image& image, std::uint32_t shrink, std::uint32_t enlarge) {
    Image out(std::max(image.width / shrink, 1U) * enlarge, std::max(image.height / shrink, 1U) * enlarge, 4);
    for (std::uint32_t y = 0; y < out.height; ++y)
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const std::uint32_t left = x / enlarge * shrink, top = y / enlarge * shrink;
            const std::uint32_t right = std::min(left + shrink, image.width),
                                bottom = std::min(top + shrink, image.height);
            float* pixel = out.at(x, y);
            for (std::uint32_t j = top; j < bottom; ++j)
                for (std::uint32_t i = left; i < right; ++i)
                    for (int c = 0; c < 3; ++c) pixel[c] += image.at(i, j)[c];
            for (int c = 0; c < 3; ++c) pixel[c] /= static_cast<float>((right - left) * (bottom - top));
            pixel[3] = 1;
        }
    return out;
}

struct SheetGrid {
    std::uint32_t shrink, enlarge;
    std::int64_t tileWidth, tileHeight, columns, rows;

    [[nodiscard]] std::int64_t width() const { return kGap + columns * (tileWidth + kGap); }
    [[nodiscard]] std::int64_t height() const { return kGap + rows * (tileHeight + kLabel + kGap); }
};

/// As many columns as bring the sheet nearest to a screen's shape.
SheetGrid gridOf(std::int64_t tiles, std::uint32_t width, std::uint32_t height) {
    const std::uint32_t most = tiles > kManyTiles ? kSmallTile : kMostTile;
    SheetGrid grid{};
    const std::uint32_t longest = std::max(width, height);
    grid.shrink = (longest + most - 1) / most;
    grid.enlarge = std::clamp((kLeastTile + width - 1) / width, 1U, std::max(most / longest, 1U));
    grid.tileWidth = std::int64_t{std::max(width / grid.shrink, 1U)} * grid.enlarge;
    grid.tileHeight = std::int64_t{std::max(height / grid.shrink, 1U)} * grid.enlarge;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int64_t columns = 1; columns <= tiles; ++columns) {
        SheetGrid next = grid;
        next.columns = columns;
        next.rows = (tiles + columns - 1) / columns;
        const double off =
            std::abs(std::log(static_cast<double>(next.width()) / static_cast<double>(next.height()) / kSheetAspect));
        if (off >= nearest) continue;
        nearest = off;
        grid.columns = next.columns;
        grid.rows = next.rows;
    }
    return grid;
}

/// As much of a name as finds room.
std::string fitted(std::string text, std::int64_t width) {
    if (textWidth(text, kTextScale) <= width) return text;
    text.resize(std::min(text.size(), static_cast<std::size_t>(width / (kGlyphAdvance * kTextScale))));
    while (!text.empty() && textWidth(text + "..", kTextScale) > width) text.pop_back();
    return text + "..";
}

void copyInto(Image& sheet, const Image& tile, std::int64_t left, std::int64_t top) {
    for (std::uint32_t y = 0; y < tile.height; ++y)
        for (std::uint32_t x = 0; x < tile.width; ++x)
            std::copy_n(tile.at(x, y), 3,
                        sheet.at(static_cast<std::uint32_t>(left) + x, static_cast<std::uint32_t>(top) + y));
}

}  // namespace

Image contactSheet(const std::vector<LightImage>& layers, const Image& sum, const Display& display) {
    const SheetGrid grid = gridOf(static_cast<std::int64_t>(layers.size()) + 1, sum.width, sum.height);
    Image sheet(static_cast<std::uint32_t>(grid.width()), static_cast<std::uint32_t>(grid.height()), 3);
    sheet.displayEncoded = true;
    fillRectangle(sheet, 0, 0, grid.width(), grid.height(), kSheetPaper);
    Display opaque = display;
    opaque.transparent = false;
    std::int64_t place = 0;
    const auto add = [&](const std::string& name, const std::string& share, const Image& image) {
        const std::int64_t left = kGap + place % grid.columns * (grid.tileWidth + kGap),
                           top = kGap + place / grid.columns * (grid.tileHeight + kLabel + kGap);
        ++place;
        copyInto(sheet, displayImage(resized(image, grid.shrink, grid.enlarge), opaque), left, top);
        const std::int64_t text = top + grid.tileHeight + 6;
        drawText(sheet, left, text, fitted(name, grid.tileWidth), kSheetInk, kTextScale);
        drawText(sheet, left, text + kLine, share, kShareInk, kTextScale);
    };
    for (const LightImage& layer : layers) add(layer.label, fmt::format("{:.3g} %", 100 * layer.share), layer.image);
    add("sum", "100 %", sum);
    return sheet;
}

}  // namespace vkpt
