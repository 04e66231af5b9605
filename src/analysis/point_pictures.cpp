#include "analysis/point_pictures.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kGap = 24, kTitle = 22;

struct Strata {
    std::uint32_t columns, rows;
};

Strata strataOf(const StudiedSampler& sampler, std::uint32_t count) {
    const auto root = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    if (!sampler.choice) return {1, 1};
    const SamplerInfo& info = samplerInfo(sampler.choice->id);
    if (info.counts == SampleCounts::Grid || info.counts == SampleCounts::Prime2) return {root, count / root};
    if (info.id == SamplerId::Lhs) return {count, count};
    if (info.id == SamplerId::Random || info.id == SamplerId::Rank1) return {1, 1};
    const auto bits = static_cast<std::uint32_t>(std::bit_width(count)) - 1;
    return {1U << ((bits + 1) / 2), 1U << (bits / 2)};
}

}  // namespace

PanelSheet::PanelSheet(std::size_t count, double side, std::size_t columns) {
    columns = std::min(columns, std::max<std::size_t>(count, 1));
    const std::size_t rows = (count + columns - 1) / columns;
    drawing.width = kGap + static_cast<double>(columns) * (side + kGap);
    drawing.height = kGap + static_cast<double>(rows) * (side + kGap + kTitle);
    for (std::size_t i = 0; i < count; ++i)
        panels.push_back({kGap + static_cast<double>(i % columns) * (side + kGap),
                          kGap + kTitle + static_cast<double>(i / columns) * (side + kGap + kTitle), side});
}

void drawPoints(Drawing& drawing, const Panel& panel, const std::string& title, const PointSet& points, std::size_t x,
                std::size_t y) {
    drawing.frame(panel.x, panel.y, panel.side, panel.side, 1, kGrey);
    drawing.text(panel.x, panel.y - 7, title, 12);
    const double spacing = panel.side / std::sqrt(static_cast<double>(std::max<std::size_t>(points.size(), 1)));
    const double radius = std::clamp(0.16 * spacing, 0.6, 3.0);
    for (std::size_t i = 0; i < points.size(); ++i)
        drawing.circle(panel.placeX(points.at(i, x)), panel.placeY(points.at(i, y)), radius, inkOf(0));
}

void drawStrata(Drawing& drawing, const Panel& panel, const StudiedSampler& sampler, std::uint32_t count) {
    const Strata strata = strataOf(sampler, count);
    for (std::uint32_t i = 1; i < strata.columns; ++i) {
        const double x = panel.placeX(static_cast<double>(i) / strata.columns);
        drawing.line(x, panel.y, x, panel.y + panel.side, 0.5, kPale);
    }
    for (std::uint32_t i = 1; i < strata.rows; ++i) {
        const double y = panel.placeY(static_cast<double>(i) / strata.rows);
        drawing.line(panel.x, y, panel.x + panel.side, y, 0.5, kPale);
    }
}

}  // namespace vkpt
