#include "void_and_cluster.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vkpt {
namespace {

constexpr double kSigma = 1.5;
constexpr int kReach = 8;             // beyond it the Gaussian is below one unit of energy
constexpr double kUnits = 1U << 20U;  // integer energies: the same mask everywhere

/// A binary pattern on a torus and the density around each of its cells.
class Pattern {
public:
    Pattern(std::uint32_t side, std::mt19937& random) : side_(static_cast<int>(side)) {
        set_.resize(std::size_t{side} * side);
        energy_.resize(set_.size());
        order_.resize(set_.size());
        std::iota(order_.begin(), order_.end(), 0U);
        std::shuffle(order_.begin(), order_.end(), random);  // how ties are broken
        for (int y = -kReach; y <= kReach; ++y)
            for (int x = -kReach; x <= kReach; ++x)
                weights_.push_back(std::lround(kUnits * std::exp(-(x * x + y * y) / (2 * kSigma * kSigma))));
    }

    void flip(std::uint32_t cell) {
        const int sign = set_[cell] ? -1 : 1, cx = static_cast<int>(cell) % side_, cy = static_cast<int>(cell) / side_;
        set_[cell] = !set_[cell];
        std::size_t w = 0;
        for (int y = cy - kReach; y <= cy + kReach; ++y)
            for (int x = cx - kReach; x <= cx + kReach; ++x)
                energy_[static_cast<std::size_t>((y + side_) % side_ * side_ + (x + side_) % side_)] +=
                    sign * weights_[w++];
    }
    [[nodiscard]] std::uint32_t tightestCluster() const { return extreme(true); }
    [[nodiscard]] std::uint32_t largestVoid() const { return extreme(false); }
    [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

private:
    /// The cell that is set and densest around, or the one that is not and emptiest around.
    [[nodiscard]] std::uint32_t extreme(bool set) const {
        std::uint32_t best = 0;
        long bestEnergy = -1;
        for (const std::uint32_t cell : order_) {
            if (set_[cell] != set) continue;
            if (bestEnergy < 0 || (set ? energy_[cell] > bestEnergy : energy_[cell] < bestEnergy)) {
                best = cell;
                bestEnergy = energy_[cell];
            }
        }
        return best;
    }

    int side_;
    std::vector<bool> set_;
    std::vector<long> energy_, weights_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::uint32_t> makeVoidAndCluster(std::uint32_t side, std::mt19937& random) {
    const std::uint32_t cells = side * side, ones = cells / 10;
    Pattern pattern(side, random);
    for (std::uint32_t i = 0; i < ones; ++i) pattern.flip(pattern.order()[i]);
    for (std::uint32_t cluster = cells, hole = 0;;) {  // move points from clusters to voids until nothing moves
        cluster = pattern.tightestCluster();
        pattern.flip(cluster);
        hole = pattern.largestVoid();
        pattern.flip(hole);
        if (hole == cluster) break;
    }

    std::vector<std::uint32_t> ranks(cells);
    Pattern thinned = pattern;
    for (std::uint32_t rank = ones; rank-- > 0;) {
        const std::uint32_t cell = thinned.tightestCluster();
        ranks[cell] = rank;
        thinned.flip(cell);
    }
    // The tightest cluster of zeros, which the second half asks for, is where the ones are fewest: the largest void.
    for (std::uint32_t rank = ones; rank < cells; ++rank) {
        const std::uint32_t cell = pattern.largestVoid();
        ranks[cell] = rank;
        pattern.flip(cell);
    }
    return ranks;
}

}  // namespace vkpt
