#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "analysis/point_set.h"

namespace vkpt {
namespace {

constexpr double kFill = 0.73;  ///< radius, of the densest packing's, at which maximal sets have `count` points
constexpr int kAttempts = 30;   ///< candidates around a point before it is given up [Bridson 07]

struct Point {
    double x = 0, y = 0;
};

double wrapped(double d) { return d - std::round(d); }

/// Points in cells so small that each holds one at most.
class Grid {
public:
    explicit Grid(double radius)
        : side_(static_cast<int>(std::ceil(std::numbers::sqrt2 / radius))),
          reach_(static_cast<int>(std::ceil(radius * side_))),
          radius2_(radius * radius),
          cells_(static_cast<std::size_t>(side_) * side_) {}

    void add(const Point& p) { cell(column(p.x), column(p.y)) = p; }
    [[nodiscard]] bool isFree(const Point& p) {
        for (int dy = -reach_; dy <= reach_; ++dy)
            for (int dx = -reach_; dx <= reach_; ++dx)
                if (const auto& other = cell(column(p.x) + dx, column(p.y) + dy)) {
                    const double x = wrapped(other->x - p.x), y = wrapped(other->y - p.y);
                    if (x * x + y * y < radius2_) return false;
                }
        return true;
    }

private:
    [[nodiscard]] int column(double x) const { return static_cast<int>(x * side_); }
    std::optional<Point>& cell(int x, int y) {
        return cells_[static_cast<std::size_t>((y + side_) % side_ * side_ + (x + side_) % side_)];
    }
    int side_, reach_;
    double radius2_;
    std::vector<std::optional<Point>> cells_;
};

}  // namespace

double poissonDiskRadius(std::uint32_t count) { return kFill * std::sqrt(2 / (std::sqrt(3.0) * count)); }

PointSet poissonDisk(std::uint32_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto uniform = [&random] { return random() * 0x1p-32; };
    const double radius = poissonDiskRadius(count);
    Grid grid(radius);
    std::vector<Point> points{{uniform(), uniform()}};
    std::vector<std::size_t> active{0};
    grid.add(points[0]);
    while (!active.empty()) {
        const auto chosen = static_cast<std::size_t>(uniform() * static_cast<double>(active.size()));
        const Point from = points[active[chosen]];
        bool found = false;
        for (int i = 0; i < kAttempts && !found; ++i) {
            const double angle = 2 * std::numbers::pi * uniform(), distance = radius * std::sqrt(1 + 3 * uniform());
            const double x = from.x + distance * std::cos(angle), y = from.y + distance * std::sin(angle);
            const Point candidate{x - std::floor(x), y - std::floor(y)};
            if (candidate.x >= 1 || candidate.y >= 1 || !grid.isFree(candidate)) continue;
            found = true;
            grid.add(candidate);
            active.push_back(points.size());
            points.push_back(candidate);
        }
        if (!found) {
            active[chosen] = active.back();
            active.pop_back();
        }
    }
    PointSet set{2, {}};
    for (const Point& p : points) set.values.insert(set.values.end(), {p.x, p.y});
    return set;
}

}  // namespace vkpt
