// Squares with points in them.
#pragma once
#include "analysis/studies.h"

namespace vkpt {

/// Where a unit square lies on a drawing; y of the square points up.
struct Panel {
    double x = 0, y = 0, side = 220;

    [[nodiscard]] double placeX(double u) const { return x + u * side; }
    [[nodiscard]] double placeY(double v) const { return y + (1 - v) * side; }
};

/// An empty drawing with room for `count` panels in rows, and the panel of each.
struct PanelSheet {
    PanelSheet(std::size_t count, double side, std::size_t columns);
    Drawing drawing;
    std::vector<Panel> panels;
};

/// Frame, title above and points of dimensions `x` and `y` of the set.
void drawPoints(Drawing& drawing, const Panel& panel, const std::string& title, const PointSet& points,
                std::size_t x = 0, std::size_t y = 1);

/// The strata that the sampler's construction promises for `count` points of a dimension pair.
void drawStrata(Drawing& drawing, const Panel& panel, const StudiedSampler& sampler, std::uint32_t count);

}  // namespace vkpt
