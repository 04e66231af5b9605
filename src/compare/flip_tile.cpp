#include "compare/flip_tile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "compare/filter.h"
#include "compare/flip_color.h"

namespace vkpt {
namespace {

/// A tile in opponent space, with the pixels around it that the filters reach; beyond the image its border repeats.
/// Grey has no cx and cz: they are empty.
struct OpponentTile {
    Grid<float> y, cx, cz;
    OpponentTile(std::size_t width, std::size_t height, bool grey)
        : y(width, height), cx(grey ? 0 : width, grey ? 0 : height), cz(cx) {}
};

/// A tile after the filters: colours as the eye resolves them, and how strong an edge and a point is where.
struct FilteredTile {
    Grid<float> y, cx, cz, edge, point;
};

OpponentTile loadTile(const Image& image, const Tile& tile, std::size_t radius, const FlipDisplay& display) {
    const bool grey = image.channels == 1;
    OpponentTile result(tile.width + 2 * radius, tile.height + 2 * radius, grey);
    const auto inside = [radius](std::size_t i, std::uint32_t first, std::uint32_t size) {
        return static_cast<std::uint32_t>(std::clamp(first + i, radius, size - 1 + radius) - radius);
    };
    for (std::size_t y = 0; y < result.y.height(); ++y) {
        const std::uint32_t imageY = inside(y, tile.y, image.height);
        for (std::size_t x = 0; x < result.y.width(); ++x) {
            const float* pixel = image.at(inside(x, tile.x, image.width), imageY);
            if (grey) {
                result.y.row(y)[x] = 116 * display(*pixel) - 16;
                continue;
            }
            const glm::vec3 color = opponentFromRgb(display(glm::vec3(pixel[0], pixel[1], pixel[2])));
            result.y.row(y)[x] = color.x;
            result.cx.row(y)[x] = color.y;
            result.cz.row(y)[x] = color.z;
        }
    }
    return result;
}

/// The tile without the `margin` pixels around it, filtered by `horizontal` along rows and `vertical` along columns.
Grid<float> filterPlane(const Grid<float>& in, const std::vector<float>& horizontal, const std::vector<float>& vertical,
                        std::size_t margin) {
    if (in.width() == 0) return in;
    return filterColumns<float>(filterRows<float>(in, horizontal, margin), vertical, margin);
}

/// a(x, y) = combine(a(x, y), b(x, y))
template <class Combine>
void combineInto(Grid<float>& a, const Grid<float>& b, const Combine& combine) {
    for (std::size_t y = 0; y < a.height(); ++y)
        for (std::size_t x = 0; x < a.width(); ++x) a.row(y)[x] = combine(a.row(y)[x], b.row(y)[x]);
}

/// What a detector finds along the two axes, as a length, luminance being in [0, 1].
Grid<float> detect(const Grid<float>& y, const std::vector<float>& detector, const FlipFilters& filters) {
    Grid<float> strength = filterPlane(y, detector, filters.gauss, filters.radius);
    combineInto(strength, filterPlane(y, filters.gauss, detector, filters.radius),
                [](float along, float across) { return std::sqrt(along * along + across * across) / 116; });
    return strength;
}

/// Opponent colours, or luminance alone, to Hunt-adjusted CIELAB in place.
void convertToLab(FilteredTile& tile) {
    const bool grey = tile.cx.width() == 0;
    for (std::size_t y = 0; y < tile.y.height(); ++y) {
        float *first = tile.y.row(y), *second = tile.cx.row(y), *third = tile.cz.row(y);
        for (std::size_t x = 0; x < tile.y.width() && grey; ++x)
            first[x] = 116 * labCurve(std::clamp((first[x] + 16) / 116, 0.0F, 1.0F)) - 16;
        for (std::size_t x = 0; x < tile.cx.width(); ++x) {
            const glm::vec3 seen = glm::clamp(rgbFromOpponent({first[x], second[x], third[x]}), 0.0F, 1.0F);
            const glm::vec3 lab = huntLabFromRgb(seen);
            first[x] = lab.x;
            second[x] = lab.y;
            third[x] = lab.z;
        }
    }
}

FilteredTile filterTile(const OpponentTile& tile, const FlipFilters& filters) {
    const auto smooth = [&](const Grid<float>& plane, const std::vector<float>& kernel) {
        return filterPlane(plane, kernel, kernel, filters.radius);
    };
    FilteredTile result{smooth(tile.y, filters.y), smooth(tile.cx, filters.cx), smooth(tile.cz, filters.czNarrow),
                        detect(tile.y, filters.edge, filters), detect(tile.y, filters.point, filters)};
    combineInto(result.cz, smooth(tile.cz, filters.czWide), std::plus<>());
    convertToLab(result);
    return result;
}

/// The error of one pixel: colour distance, raised by what edges and points differ. [Andersson 20, eqs. 8 and 9]
float pixelFlip(const FilteredTile& a, const FilteredTile& r, std::size_t x, std::size_t y) {
    const auto lab = [&](const FilteredTile& tile) {
        return tile.cx.width() == 0 ? glm::vec3(tile.y.row(y)[x], 0, 0)
                                    : glm::vec3(tile.y.row(y)[x], tile.cx.row(y)[x], tile.cz.row(y)[x]);
    };
    const float edge = std::abs(a.edge.row(y)[x] - r.edge.row(y)[x]);
    const float point = std::abs(a.point.row(y)[x] - r.point.row(y)[x]);
    const float feature = std::sqrt(std::max(edge, point) * std::sqrt(0.5F));
    return std::pow(flipFromHyab(hyab(lab(a), lab(r))), 1 - feature);
}

}  // namespace

void raiseToFlip(const Image& image, const Image& reference, const Tile& tile, const FlipFilters& filters,
                 const FlipDisplay& display, Image& map) {
    const FilteredTile a = filterTile(loadTile(image, tile, filters.radius, display), filters);
    const FilteredTile r = filterTile(loadTile(reference, tile, filters.radius, display), filters);
    for (std::uint32_t y = 0; y < tile.height; ++y) {
        for (std::uint32_t x = 0; x < tile.width; ++x) {
            float& value = *map.at(tile.x + x, tile.y + y);
            value = std::max(value, pixelFlip(a, r, x, y));
        }
    }
}

}  // namespace vkpt
