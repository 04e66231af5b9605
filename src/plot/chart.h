// Curves over two axes.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "plot/drawing.h"

namespace vkpt {

struct Curve {
    std::string name;  ///< shown beside the chart; empty: not shown
    std::vector<std::pair<double, double>> points;
    bool marks = true;  ///< a dot at each point
    bool dashed = false;
};

/// Where a chart lies on a drawing, its frame and its axes.
struct ChartFrame {
    double x = 0, y = 0, width = 0, height = 0;
    bool logarithmic = false;  ///< both axes; points that are not positive are left out
    std::string title, xName, yName;
};

/// Axes span all points. Legend to the right of the frame, coloured by inkOf(index of the curve).
void drawChart(Drawing& drawing, const ChartFrame& frame, const std::vector<Curve>& curves);

}  // namespace vkpt
