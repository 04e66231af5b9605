#include "analysis/discrepancy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vkpt {
namespace {

double power(double base, std::size_t exponent) { return std::pow(base, static_cast<double>(exponent)); }

/// The mean of `term` over the points' coordinates, multiplied over dimensions.
template <class Term>
double meanProduct(const PointSet& points, const Term& term) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double product = 1;
        for (std::size_t d = 0; d < points.dims; ++d) product *= term(points.at(i, d));
        sum += product;
    }
    return sum / static_cast<double>(points.size());
}

/// The same over all ordered pairs of points.
template <class Term>
double meanPairProduct(const PointSet& points, const Term& term) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < points.size(); ++j) {
            double product = 1;
            for (std::size_t d = 0; d < points.dims; ++d) product *= term(points.at(i, d), points.at(j, d));
            sum += product;
        }
    return sum / (static_cast<double>(points.size()) * static_cast<double>(points.size()));
}

double root(double square) { return std::sqrt(std::max(square, 0.0)); }

/// Counts along y for a box whose right edge moves over the points from left to right.
class StarSearch {
public:
    explicit StarSearch(const PointSet& points) : points_(points), order_(points.size()), edges_{1} {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::ranges::sort(order_, {}, [&](std::size_t i) { return points.at(i, 0); });
        for (std::size_t i = 0; i < points.size(); ++i) edges_.push_back(points.at(i, 1));
        std::ranges::sort(edges_);
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
        counts_.resize(edges_.size());
    }

    StarDiscrepancy run() {
        for (std::size_t i = 0; i < order_.size();) {
            const double x = points_.at(order_[i], 0);
            consider(x, false);  // open: points left of x
            for (; i < order_.size() && points_.at(order_[i], 0) == x; ++i) insert(points_.at(order_[i], 1));
            consider(x, true);
        }
        consider(1, false);
        return best_;
    }

private:
    void insert(double y) { ++counts_[static_cast<std::size_t>(std::ranges::lower_bound(edges_, y) - edges_.begin())]; }

    /// All upper edges for the right edge x. `closed`: points at x are in.
    void consider(double x, bool closed) {
        std::size_t below = 0;
        const auto n = static_cast<double>(points_.size());
        for (std::size_t k = 0; k < edges_.size(); ++k) {
            const std::size_t inside = closed ? below + counts_[k] : below;
            const double share = static_cast<double>(inside) / n, area = x * edges_[k];
            const double value = closed ? share - area : area - share;
            if (value > best_.value) best_ = {value, x, edges_[k], inside, closed};
            below += counts_[k];
        }
    }

    const PointSet& points_;
    std::vector<std::size_t> order_;
    std::vector<double> edges_;        ///< distinct y, and 1
    std::vector<std::size_t> counts_;  ///< points so far at each
    StarDiscrepancy best_;
};

}  // namespace

StarDiscrepancy starDiscrepancy(const PointSet& points) { return StarSearch(points).run(); }

double l2Star(const PointSet& p) {
    const double cross = meanProduct(p, [](double x) { return (1 - x * x) / 2; });
    const double pairs = meanPairProduct(p, [](double x, double y) { return 1 - std::max(x, y); });
    return root(power(1.0 / 3, p.dims) - 2 * cross + pairs);
}

double l2Centred(const PointSet& p) {
    const double cross = meanProduct(p, [](double x) {
        const double z = std::abs(x - 0.5);
        return 1 + z / 2 - z * z / 2;
    });
    const double pairs = meanPairProduct(
        p, [](double x, double y) { return 1 + std::abs(x - 0.5) / 2 + std::abs(y - 0.5) / 2 - std::abs(x - y) / 2; });
    return root(power(13.0 / 12, p.dims) - 2 * cross + pairs);
}

double l2Wrapped(const PointSet& p) {
    const double pairs = meanPairProduct(p, [](double x, double y) {
        const double d = std::abs(x - y);
        return 1.5 - d * (1 - d);
    });
    return root(pairs - power(4.0 / 3, p.dims));
}

double randomL2Star(std::size_t n, std::size_t dims) {
    return root((power(0.5, dims) - power(1.0 / 3, dims)) / static_cast<double>(n));
}

double randomL2Centred(std::size_t n, std::size_t dims) {
    return root((power(1.25, dims) - power(13.0 / 12, dims)) / static_cast<double>(n));
}

double randomL2Wrapped(std::size_t n, std::size_t dims) {
    return root((power(1.5, dims) - power(4.0 / 3, dims)) / static_cast<double>(n));
}

double randomStar(std::size_t n) {
    double sum = 0;
    for (std::uint32_t seed = 0; seed < kRandomStarSets; ++seed)
        sum += starDiscrepancy(samplePoints(SamplerId::Random, static_cast<std::uint32_t>(n), {0, 1}, seed)).value;
    return sum / kRandomStarSets;
}

}  // namespace vkpt
