#include "analysis/environment_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/math.h"
#include "compare/false_color.h"
#include "film/tonemap.h"

namespace vkpt {
namespace {

constexpr double kMargin = 24, kCaption = 22, kWidth = 640, kMarginal = 140;
constexpr std::uint32_t kRows = 160;  ///< of the pictures, at most

/// Texels [first, second) under one of `cells` cells; at least one.
std::pair<std::uint32_t, std::uint32_t> texelsOf(std::uint32_t cell, std::uint32_t cells, std::uint32_t texels) {
    const auto edge = [&](std::uint32_t i) { return static_cast<std::uint32_t>(std::uint64_t{i} * texels / cells); };
    const std::uint32_t first = std::min(edge(cell), texels - 1);
    return {first, std::max(first + 1, edge(cell + 1))};
}

/// Mean of the texels under each cell of a grid.
std::vector<glm::dvec3> shrink(const SceneArrays& e, std::uint32_t columns, std::uint32_t rows) {
    std::vector<glm::dvec3> cells;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const auto [x0, x1] = texelsOf(i, columns, e.envWidth);
            const auto [y0, y1] = texelsOf(j, rows, e.envHeight);
            glm::dvec3 sum(0);
            for (std::uint32_t y = y0; y < y1; ++y)
                for (std::uint32_t x = x0; x < x1; ++x)
                    sum += glm::dvec3(glm::vec3(e.envTexels[std::size_t{y} * e.envWidth + x]));
            cells.push_back(sum / (double(x1 - x0) * double(y1 - y0)));
        }
    return cells;
}

double brightness(const glm::dvec3& c) { return double{luminance(glm::vec3(c))}; }

/// Display-encoded; the mean luminance becomes `grey`.
Image developed(const std::vector<glm::dvec3>& cells, std::uint32_t columns, std::uint32_t rows, double grey) {
    double mean = 0;
    for (const glm::dvec3& cell : cells) mean += brightness(cell) / static_cast<double>(cells.size());
    Image image(columns, rows, 3);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const glm::vec3 shown = toneMap(ToneMap::Neutral, glm::vec3(cells[i] * (mean > 0 ? grey / mean : 0)));
        for (int c = 0; c < 3; ++c) image.pixels[3 * i + static_cast<std::size_t>(c)] = srgbEncode(shown[c]);
    }
    return image;
}

/// Luminance x sin(theta) of every cell.
std::vector<double> importanceOf(const std::vector<glm::dvec3>& cells, std::uint32_t columns, std::uint32_t rows) {
    std::vector<double> values(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        values[i] = brightness(cells[i]) *
                    std::sin(std::numbers::pi * (static_cast<double>(i / columns) + 0.5) / static_cast<double>(rows));
    return values;
}

/// False colours of four decades below the largest value: of each `run` values by themselves.
Image decades(const std::vector<double>& values, std::uint32_t columns, std::size_t run) {
    Image image(columns, static_cast<std::uint32_t>(values.size() / columns), 3);
    for (std::size_t first = 0; first < values.size(); first += run) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
        const double top = *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(run));
        for (std::size_t i = first; i < first + run; ++i) {
            const double below = values[i] > 0 ? std::log10(values[i] / top) : -4;
            const glm::vec3 color = falseColor(static_cast<float>(std::max(0.0, 1 + below / 4)));
            std::copy_n(&color.x, 3, image.pixels.data() + 3 * i);
        }
    }
    return image;
}

/// Probability of each row of the map, its curve running down beside the picture of the importance.
void drawMarginal(Drawing& d, const SceneArrays& e, double x, double y, double height) {
    const std::uint32_t bands = std::min(e.envHeight, 256U);
    const auto cdf = [&](std::uint32_t band) {
        const auto row = static_cast<std::uint32_t>(std::uint64_t{band} * e.envHeight / bands);
        return row == 0 ? 0.0 : double{e.envRows[row - 1]};
    };
    std::vector<double> shares;
    for (std::uint32_t i = 0; i < bands; ++i) shares.push_back(cdf(i + 1) - cdf(i));
    const double top = *std::ranges::max_element(shares), step = height / bands;
    d.frame(x, y, kMarginal, height, 1, kPale);
    for (std::uint32_t i = 0; i < bands; ++i) {
        const double x1 = x + kMarginal * shares[i] / top, x0 = i == 0 ? x : x + kMarginal * shares[i - 1] / top;
        d.line(x0, y + i * step, x1, y + i * step, 1.5, inkOf(0));
        d.line(x1, y + i * step, x1, y + (i + 1) * step, 1.5, inkOf(0));
    }
    d.text(x, y - 6, "marginal of the rows", 12);
}

}  // namespace

Drawing drawEnvironment(const std::string& name, const SceneArrays& e, const std::vector<glm::dvec2>& places) {
    // However many texels there are each way, the map is the whole sphere: twice as wide as high.
    const std::uint32_t rows = std::clamp(std::max(e.envHeight, (e.envWidth + 1) / 2), 1U, kRows), columns = 2 * rows;
    const double height = kWidth / 2;
    const auto cells = shrink(e, columns, rows);
    const std::vector<double> importance = importanceOf(cells, columns, rows);
    Drawing d;
    d.width = 3 * kMargin + kWidth + kMarginal;
    d.height = 4 * (height + kCaption + kMargin) + kMargin;
    double y = kMargin + kCaption;
    const auto title = [&](const std::string& text) { d.text(kMargin, y - 6, text, 12); };
    title(fmt::format("{}, {}x{}", name, e.envWidth, e.envHeight));
    d.picture(kMargin, y, kWidth, developed(cells, columns, rows, 0.4));
    y += height + kMargin + kCaption;
    title("scalar importance: luminance x sin(theta), four decades");
    d.picture(kMargin, y, kWidth, decades(importance, columns, importance.size()));
    drawMarginal(d, e, 2 * kMargin + kWidth, y, height);
    y += height + kMargin + kCaption;
    title("conditional density of the columns: every row by itself, four decades below its peak");
    d.picture(kMargin, y, kWidth, decades(importance, columns, columns));
    y += height + kMargin + kCaption;
    title(fmt::format("where {} samples fall", places.size()));
    d.picture(kMargin, y, kWidth, developed(cells, columns, rows, 0.15));
    for (const glm::dvec2& place : places) {
        d.circle(kMargin + place.x * kWidth, y + place.y * height, 2.4, kBlack);
        d.circle(kMargin + place.x * kWidth, y + place.y * height, 1.7, inkOf(1));
    }
    return d;
}

}  // namespace vkpt
