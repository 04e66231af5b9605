#include "analysis/sphere_quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/warp.h"

namespace vkpt {

namespace {

class Quadrature {
public:
    Quadrature(const DirectionFunction& f, bool upper, std::span<const glm::dvec3> peaks,
               const QuadratureConfig& config)
        : f_(f), upper_(upper), config_(config) {
        for (const glm::dvec3& peak : peaks)
            if (upper == (peak.z > 0)) peaks_.push_back(squareOfDirection(peak));
    }

    [[nodiscard]] glm::dvec4 refine(double x, double y, double size, int depth) const {
        return refine(x, y, size, depth, estimate(x, y, size));
    }

private:
    /// Gauss's rule of 3 x 3 points.
    [[nodiscard]] glm::dvec4 estimate(double x, double y, double size) const {
        static const double kOffset = std::sqrt(0.6) / 2;
        const double at[3] = {0.5 - kOffset, 0.5, 0.5 + kOffset}, weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
        glm::dvec4 sum(0);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                sum += weight[i] * weight[j] * f_(directionOfSquare({x + size * at[i], y + size * at[j]}, upper_));
        return sum * (2 * std::numbers::pi * size * size);
    }

    [[nodiscard]] bool holdsPeak(double x, double y, double size) const {
        return std::ranges::any_of(peaks_, [&](const glm::dvec2& p) {
            const double margin = size / 2;  // a peak at the edge belongs to both sides
            return p.x >= x - margin && p.x <= x + size + margin && p.y >= y - margin && p.y <= y + size + margin;
        });
    }

    [[nodiscard]] glm::dvec4 refine(double x, double y, double size, int depth, const glm::dvec4& coarse) const {
        const double half = size / 2;
        const double corners[4][2] = {{x, y}, {x + half, y}, {x, y + half}, {x + half, y + half}};
        glm::dvec4 parts[4], fine(0);
        for (int i = 0; i < 4; ++i) fine += parts[i] = estimate(corners[i][0], corners[i][1], half);
        const glm::dvec4 miss = glm::abs(fine - coarse);
        const double error = std::max({miss.x, miss.y, miss.z, miss.w});
        const bool forced = depth < config_.leastDepth || (depth < config_.peakDepth && holdsPeak(x, y, size));
        if (!forced && (error < config_.tolerance || depth >= std::max(config_.mostDepth, config_.peakDepth + 3)))
            return fine;
        fine = glm::dvec4(0);
        for (int i = 0; i < 4; ++i) fine += refine(corners[i][0], corners[i][1], half, depth + 1, parts[i]);
        return fine;
    }

    const DirectionFunction& f_;
    bool upper_;
    const QuadratureConfig& config_;
    std::vector<glm::dvec2> peaks_;
};

}  // namespace

glm::dvec3 directionOfSquare(const glm::dvec2& u, bool upper) {
    const glm::dvec2 disk = reference::squareToDisk(u);
    const double r2 = glm::dot(disk, disk), z = std::max(0.0, 1 - r2);
    return {disk * std::sqrt(2 - r2), upper ? z : -z};
}

glm::dvec2 squareOfDirection(const glm::dvec3& w) {
    const double r = std::sqrt(std::max(0.0, 1 - std::abs(w.z)));
    if (r == 0) return {0.5, 0.5};
    const double turns = std::atan2(w.y, w.x) / (2 * std::numbers::pi);
    // The concentric map: of four triangles of the square, the one about +x, +y, -x or -y.
    const double eighths = 8 * turns;
    glm::dvec2 ab;
    if (std::abs(eighths) <= 1)
        ab = {r, r * eighths};
    else if (std::abs(eighths) >= 3)
        ab = {-r, -r * (eighths > 0 ? eighths - 4 : eighths + 4)};
    else if (eighths > 0)
        ab = {r * (2 - eighths), r};
    else
        ab = {-r * (-2 - eighths), -r};
    return (ab + 1.0) / 2.0;
}

glm::dvec4 integrate(const DirectionFunction& f, const SphereCell& cell, std::span<const glm::dvec3> peaks,
                     const QuadratureConfig& config) {
    const int depth = static_cast<int>(std::lround(-std::log2(cell.size)));
    return Quadrature(f, cell.upper, peaks, config).refine(cell.x, cell.y, cell.size, depth);
}

}  // namespace vkpt
