#include "verify/images/path_differences.h"

#include <algorithm>
#include <cmath>

#include "base/image.h"

namespace vkpt {

void PathDifferences::add(const Film& device, const Film& reference) {
    add(filmToImage(device), filmToImage(reference), reference.sampleBegin());
}

void PathDifferences::add(const Image& a, const Image& b, std::uint32_t index) {
    for (std::uint32_t y = 0; y < b.height; ++y)
        for (std::uint32_t x = 0; x < b.width; ++x) {
            bool off = false;
            double size = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double actual = double{a.at(x, y)[c]}, expected = double{b.at(x, y)[c]},
                             error = actual - expected;
                off |= !(std::abs(error) <= kRelative * std::max(std::abs(actual), std::abs(expected)));
                size = std::max(size, std::abs(error));
                sum_[c] += error;
                squares_[c] += error * error;
                reference_[c] += expected;
            }
            ++paths_;
            if (!off) continue;
            ++parted_;
            partedSum_ += size;
            if (!worst_ || size > worst_->size) worst_ = {x, y, index, size};
        }
}

double PathDifferences::partedSize() const {
    const double all = (mean(0) + mean(1) + mean(2)) / 3;
    return parted_ == 0 || all == 0 ? 0 : partedSum_ / static_cast<double>(parted_) / all;
}

double PathDifferences::mean(int channel) const {
    return reference_[static_cast<std::size_t>(channel)] / static_cast<double>(paths_);
}

double PathDifferences::meanDifference(int channel) const {
    return sum_[static_cast<std::size_t>(channel)] / static_cast<double>(paths_);
}

double PathDifferences::standardError(int channel) const {
    const auto n = static_cast<double>(paths_);
    const double m = meanDifference(channel);
    return std::sqrt(std::max(0.0, squares_[static_cast<std::size_t>(channel)] / n - m * m) / n);
}

double PathDifferences::meanShare(int channel) const {
    const double allowed = 3 * standardError(channel) + kRounding * mean(channel);
    const double m = std::abs(meanDifference(channel));
    return m == 0 ? 0 : m / allowed;
}

}  // namespace vkpt
