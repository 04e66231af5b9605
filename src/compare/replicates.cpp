#include "compare/replicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vkpt {
namespace {

constexpr std::uint32_t kTile = ReplicateResult::kTile;

double meanOf(const Image& image, const MeanComparison& area) {
    double sum = 0;
    for (std::uint32_t y = area.y; y < area.y + area.height; ++y)
        for (std::uint32_t x = area.x; x < area.x + area.width; ++x) sum += double{image.at(x, y)[area.channel]};
    return sum / (static_cast<double>(area.width) * area.height);
}

/// The two means of one area, image by image.
struct Area {
    MeanComparison result;
    std::vector<double> a, b;

    void judge() {
        result.a = momentsOf(a);
        result.b = momentsOf(b);
        if (!std::isfinite(result.a.variance + result.b.variance)) {  // no number is no agreement
            result.test = {std::numeric_limits<double>::infinity(), 0, 0};
            return;
        }
        Moments shifted = result.a;  // towards b by what rounding may do
        const double difference = result.a.mean - result.b.mean;
        const double allowed = ReplicateResult::kRounding * std::abs(result.a.mean + result.b.mean) / 2;
        shifted.mean -= std::copysign(std::min(std::abs(difference), allowed), difference);
        result.test = welchTest(shifted, result.b);
    }
};

/// The tiles, then the whole image.
std::vector<Area> makeAreas(std::uint32_t width, std::uint32_t height) {
    std::vector<Area> areas;
    const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t w, std::uint32_t h) {
        for (std::uint32_t channel = 0; channel < 3; ++channel)
            areas.push_back({{x, y, w, h, channel, {}, {}, {}}, {}, {}});
    };
    for (std::uint32_t y = 0; y < height; y += kTile)
        for (std::uint32_t x = 0; x < width; x += kTile)
            add(x, y, std::min(kTile, width - x), std::min(kTile, height - y));
    add(0, 0, width, height);
    return areas;
}

void addTo(Image& sum, const Image& image) {
    if (sum.pixels.empty()) sum = Image(image.width, image.height, image.channels);
    std::ranges::transform(sum.pixels, image.pixels, sum.pixels.begin(), std::plus{});
}

}  // namespace

const MeanComparison& ReplicateResult::worst() const {
    const auto p = [](const MeanComparison& c) { return c.test.p; };
    const auto tile = std::ranges::min_element(tiles, {}, p), image = std::ranges::min_element(whole, {}, p);
    return image->test.p <= tile->test.p ? *image : *tile;
}

double ReplicateResult::limit() const {
    const MeanComparison& c = worst();
    return criticalT(level, c.test.degrees > 0 ? c.test.degrees : static_cast<double>(2 * c.a.count - 2));
}

ReplicateResult compareReplicates(const RenderSeed& a, const RenderSeed& b, std::uint32_t firstSeed,
                                  std::uint32_t count, const std::function<void(std::uint32_t done)>& progress) {
    ReplicateResult result;
    std::vector<Area> areas;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Image x = a(firstSeed + i), y = b(firstSeed + count + i);
        if (i == 0) areas = makeAreas(x.width, x.height);
        for (Area& area : areas) {
            area.a.push_back(meanOf(x, area.result));
            area.b.push_back(meanOf(y, area.result));
        }
        addTo(result.meanA, x);
        addTo(result.meanB, y);
        if (progress) progress(i + 1);
    }
    for (Image* mean : {&result.meanA, &result.meanB})
        for (float& value : mean->pixels) value /= static_cast<float>(count);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        areas[i].judge();
        (i + 3 < areas.size() ? result.tiles : result.whole).push_back(areas[i].result);
    }
    result.level = sidakLevel(ReplicateResult::kFamilyLevel, areas.size());
    return result;
}

}  // namespace vkpt
