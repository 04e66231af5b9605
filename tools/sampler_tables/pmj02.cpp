#include "pmj02.h"

#include <stdexcept>

namespace vkpt {
namespace {

constexpr unsigned kBits = 16;

std::uint32_t drawBelow(std::mt19937& random, std::uint32_t n) {
    return static_cast<std::uint32_t>(std::uint64_t{random()} * n >> 32U);
}

/// Which elementary intervals of area 2^-m hold a point. Shape a is 2^-a wide and 2^-(m-a) high.
class Occupancy {
public:
    Occupancy(unsigned m, const std::vector<Point16>& points)
        : m_(m), taken_(m + 1, std::vector<bool>(std::size_t{1} << m)) {
        for (const Point16& p : points) add(p);
    }
    void add(const Point16& p) {
        for (unsigned a = 0; a <= m_; ++a) taken_[a][cell(a, p.x, p.y)] = true;
    }
    [[nodiscard]] bool isTaken(unsigned a, std::uint32_t x, std::uint32_t y) const { return taken_[a][cell(a, x, y)]; }
    [[nodiscard]] unsigned m() const { return m_; }

private:
    [[nodiscard]] std::size_t cell(unsigned a, std::uint32_t x, std::uint32_t y) const {
        return std::size_t{x >> (kBits - a)} << (m_ - a) | y >> (kBits - (m_ - a));
    }
    unsigned m_;
    std::vector<std::vector<bool>> taken_;
};

/// One coordinate of a point in a square of side 2^-s: a stratum of 2^-m that no interval forbids, and a place in it.
/// Intervals narrower than the square are at least as high as it, so x and y are drawn independently.
std::uint32_t drawCoordinate(const Occupancy& occupancy, unsigned s, std::uint32_t x0, std::uint32_t y0, bool alongX,
                             std::mt19937& random) {
    const unsigned m = occupancy.m();
    const std::uint32_t step = 1U << (kBits - m);
    std::vector<std::uint32_t> free;
    for (std::uint32_t offset = 0; offset < 1U << (kBits - s); offset += step) {
        const std::uint32_t x = alongX ? x0 + offset : x0, y = alongX ? y0 : y0 + offset;
        bool taken = false;
        for (unsigned narrow = s + 1; narrow <= m && !taken; ++narrow)
            taken = occupancy.isTaken(alongX ? narrow : m - narrow, x, y);
        if (!taken) free.push_back(alongX ? x : y);
    }
    if (free.empty()) throw std::logic_error("pmj02: no stratum is free");
    return free[drawBelow(random, static_cast<std::uint32_t>(free.size()))] + drawBelow(random, step);
}

class Generator {
public:
    explicit Generator(std::mt19937& random) : random_(random) {
        points_.push_back({drawBelow(random_, 1U << kBits), drawBelow(random_, 1U << kBits)});
    }

    /// 4^j points become 4^(j+1).
    void extend(unsigned j) {
        const std::size_t n = points_.size();
        const unsigned s = j + 1;
        const std::uint32_t flip = 1U << (kBits - s);
        Occupancy twice(2 * j + 1, points_);
        for (std::size_t i = 0; i < n; ++i) place(twice, s, points_[i].x ^ flip, points_[i].y ^ flip);
        Occupancy fourfold(2 * j + 2, points_);
        for (std::size_t i = 0; i < n; ++i) {
            const bool alongX = drawBelow(random_, 2) == 0;
            place(fourfold, s, points_[i].x ^ (alongX ? flip : 0), points_[i].y ^ (alongX ? 0 : flip));
        }
        for (std::size_t i = 0; i < n; ++i)
            place(fourfold, s, points_[2 * n + i].x ^ flip, points_[2 * n + i].y ^ flip);
    }

    [[nodiscard]] const std::vector<Point16>& points() const { return points_; }

private:
    /// Adds a point in the square of side 2^-s that holds (x, y).
    void place(Occupancy& occupancy, unsigned s, std::uint32_t x, std::uint32_t y) {
        const std::uint32_t corner = ~((1U << (kBits - s)) - 1);
        const std::uint32_t newX = drawCoordinate(occupancy, s, x & corner, y & corner, true, random_);
        const std::uint32_t newY = drawCoordinate(occupancy, s, x & corner, y & corner, false, random_);
        points_.push_back({newX, newY});
        occupancy.add(points_.back());
    }

    std::mt19937& random_;
    std::vector<Point16> points_;
};

}  // namespace

std::vector<Point16> makePmj02(unsigned log4Count, std::mt19937& random) {
    Generator generator(random);
    for (unsigned j = 0; j < log4Count; ++j) generator.extend(j);
    return generator.points();
}

}  // namespace vkpt
