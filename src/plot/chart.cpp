#include "plot/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt {
namespace {

/// One axis: values to places, and where its ticks are.
class Axis {
public:
    explicit Axis(bool logarithmic) : log_(logarithmic) {}

    void include(double value) {
        low_ = std::min(low_, mapped(value));
        high_ = std::max(high_, mapped(value));
    }
    void finish() {
        if (!(low_ < high_)) low_ -= 0.5, high_ = low_ + 1;
        const double margin = 0.04 * (high_ - low_);
        low_ -= margin, high_ += margin;
    }
    [[nodiscard]] bool holds(double value) const { return std::isfinite(value) && (!log_ || value > 0); }
    /// 0 at the lower end, 1 at the upper.
    [[nodiscard]] double place(double value) const { return (mapped(value) - low_) / (high_ - low_); }

    [[nodiscard]] std::vector<std::pair<double, std::string>> ticks() const {
        std::vector<std::pair<double, std::string>> result;
        const double span = high_ - low_;
        double step = std::pow(10, std::floor(std::log10(span / 4)));
        if (log_)
            step = std::max(1.0, std::ceil(span / 7));
        else if (span / step > 10)
            step *= span / step > 20 ? 5 : 2;
        for (double k = std::ceil(low_ / step); k * step <= high_; ++k) {
            const double t = k * step + 0.0;  // not -0
            result.emplace_back((t - low_) / span, log_ ? fmt::format("1e{:.0f}", t) : fmt::format("{:.4g}", t));
        }
        return result;
    }

private:
    [[nodiscard]] double mapped(double value) const { return log_ ? std::log10(value) : value; }
    bool log_;
    double low_ = std::numeric_limits<double>::max(), high_ = std::numeric_limits<double>::lowest();
};

struct Axes {
    Axis x, y;
    explicit Axes(const ChartFrame& f, const std::vector<Curve>& curves) : x(f.logarithmic), y(f.logarithmic) {
        for (const Curve& curve : curves)
            for (const auto& [a, b] : curve.points)
                if (x.holds(a) && y.holds(b)) x.include(a), y.include(b);
        x.finish(), y.finish();
    }
};

void drawAxes(Drawing& d, const ChartFrame& f, const Axes& axes) {
    for (const auto& [place, label] : axes.x.ticks()) {
        const double x = f.x + place * f.width;
        d.line(x, f.y, x, f.y + f.height, 0.6, kPale);
        d.text(x, f.y + f.height + 15, label, 11, Align::Middle);
    }
    for (const auto& [place, label] : axes.y.ticks()) {
        const double y = f.y + (1 - place) * f.height;
        d.line(f.x, y, f.x + f.width, y, 0.6, kPale);
        d.text(f.x - 6, y + 4, label, 11, Align::Right);
    }
    d.frame(f.x, f.y, f.width, f.height, 1, kGrey);
    d.text(f.x + f.width / 2, f.y + f.height + 32, f.xName, 12, Align::Middle);
    d.text(f.x - 40, f.y - 8, f.yName, 12);
    d.text(f.x + f.width / 2, f.y - 8, f.title, 13, Align::Middle);
}

void drawCurve(Drawing& d, const ChartFrame& f, const Axes& axes, const Curve& curve, Ink ink) {
    bool open = false;
    double lastX = 0, lastY = 0;
    std::size_t drawn = 0;
    for (const auto& [a, b] : curve.points) {
        if (!axes.x.holds(a) || !axes.y.holds(b)) {
            open = false;
            continue;
        }
        const double x = f.x + axes.x.place(a) * f.width, y = f.y + (1 - axes.y.place(b)) * f.height;
        if (open && !(curve.dashed && drawn++ % 2 == 1)) d.line(lastX, lastY, x, y, curve.dashed ? 1 : 1.6, ink);
        if (curve.marks) d.circle(x, y, 2.4, ink);
        open = true, lastX = x, lastY = y;
    }
}

}  // namespace

void drawChart(Drawing& drawing, const ChartFrame& frame, const std::vector<Curve>& curves) {
    const Axes axes(frame, curves);
    drawAxes(drawing, frame, axes);
    double legend = frame.y + 10;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        drawCurve(drawing, frame, axes, curves[i], inkOf(i));
        if (curves[i].name.empty()) continue;
        const double x = frame.x + frame.width + 12;
        drawing.line(x, legend - 4, x + 16, legend - 4, 2.4, inkOf(i));
        drawing.text(x + 22, legend, curves[i].name, 12);
        legend += 16;
    }
}

}  // namespace vkpt
