#include "verify/images/path_differences.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/image.h"

namespace vkpt {

namespace {

/// Whether the pixel is off by more than kRelative in a channel; NaN is.
bool parts(const Image& a, const Image& b, std::uint32_t x, std::uint32_t y) {
    bool off = false;
    for (std::size_t c = 0; c < 3; ++c) {
        const double p = double{a.at(x, y)[c]}, q = double{b.at(x, y)[c]};
        off |= !(std::abs(p - q) <= PathDifferences::kRelative * std::max(std::abs(p), std::abs(q)));
    }
    return off;
}

/// Orders paths by what is worst to find.
std::pair<bool, double> rank(const PathDifferences::Parted& path) { return {!path.excused, path.size}; }

}  // namespace

void PathDifferences::add(const Film& device, const Film& reference, std::span<const Film> twins) {
    std::vector<Image> images;
    for (const Film& twin : twins) images.push_back(filmToImage(twin));
    add(filmToImage(device), filmToImage(reference), reference.sampleBegin(), images);
}

void PathDifferences::add(const Image& a, const Image& b, std::uint32_t index, std::span<const Image> twins) {
    for (std::uint32_t y = 0; y < b.height; ++y)
        for (std::uint32_t x = 0; x < b.width; ++x) {
            double size = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double actual = double{a.at(x, y)[c]}, expected = double{b.at(x, y)[c]},
                             error = actual - expected;
                size = std::max(size, std::abs(error));
                sum_[c] += error;
                squares_[c] += error * error;
                reference_[c] += expected;
            }
            ++paths_;
            if (!parts(a, b, x, y)) continue;
            ++parted_;
            partedSum_ += size;
            const bool excused = std::ranges::any_of(twins, [&](const Image& twin) { return parts(twin, b, x, y); });
            if (excused) ++excused_;
            const Parted path{x, y, index, size, excused};
            if (!worst_ || rank(path) > rank(*worst_)) worst_ = path;
        }
}

double PathDifferences::mostParted(const RenderParams& params) { return 0.0005 * (pathDepth(params) + 1); }

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
