#include "compare/flip.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "base/math.h"
#include "compare/flip_tile.h"

namespace vkpt {
namespace {

constexpr float kBrightest = 65536;

template <class Function>
Image mapValues(const Image& image, const Function& function) {
    Image result(image.width, image.height, image.channels);
    oneapi::tbb::parallel_for(std::uint32_t{0}, image.height, [&](std::uint32_t y) {
        const float* row = image.at(0, y);
        std::transform(row, row + std::size_t{image.width} * image.channels, result.at(0, y), function);
    });
    return result;
}

double sumTile(const Image& map, const Tile& tile) {
    double sum = 0;
    for (std::uint32_t y = 0; y < tile.height; ++y)
        for (std::uint32_t x = 0; x < tile.width; ++x) sum += *map.at(tile.x + x, tile.y + y);
    return sum;
}

/// The largest error over the displays, of images of linear light.
FlipResult flipOver(const std::vector<FlipDisplay>& displays, const Image& image, const Image& reference) {
    assert(image.channels == reference.channels && (image.channels == 1 || image.channels == 3));
    assert(image.width == reference.width && image.height == reference.height && !image.pixels.empty());
    const FlipFilters filters = makeFlipFilters(kFlipPixelsPerDegree);
    FlipResult result{0, Image(image.width, image.height, 1)};
    const double sum = sumOverTiles(image.width, image.height, [&](const Tile& tile) {
        for (const FlipDisplay& display : displays) raiseToFlip(image, reference, tile, filters, display, result.map);
        return sumTile(result.map, tile);
    });
    result.mean = sum / static_cast<double>(result.map.pixels.size());
    return result;
}

double median(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + double{*std::max_element(values.begin(), middle)}) / 2;
}

}  // namespace

FlipResult ldrFlip(const Image& image, const Image& reference) {
    const auto decode = [](float v) { return srgbToLinear(std::clamp(v, 0.0F, 1.0F)); };
    return flipOver({FlipDisplay{}}, mapValues(image, decode), mapValues(reference, decode));
}

FlipResult hdrFlip(const Image& image, const Image& reference, const FlipExposures& exposures) {
    const double step = (exposures.stop - exposures.start) / std::max(1U, exposures.count - 1);
    std::vector<FlipDisplay> displays;
    for (std::uint32_t i = 0; i < exposures.count; ++i)
        displays.push_back({true, static_cast<float>(std::exp2(exposures.start + i * step))});
    const auto bound = [](float v) { return std::clamp(v, 0.0F, kBrightest); };
    return flipOver(displays, mapValues(image, bound), mapValues(reference, bound));
}

FlipExposures flipExposures(const Image& reference) {
    constexpr double shown = 0.85, mostStops = 20;
    std::vector<float> luminances;
    luminances.reserve(std::size_t{reference.width} * reference.height);
    for (std::size_t i = 0; i < reference.pixels.size(); i += reference.channels) {
        const float* pixel = &reference.pixels[i];
        const glm::vec3 color = reference.channels == 1 ? glm::vec3(*pixel) : glm::vec3(pixel[0], pixel[1], pixel[2]);
        luminances.push_back(luminance(glm::clamp(color, 0.0F, kBrightest)));
    }
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    if (largest <= 0) return {};
    double middle = median(luminances);
    if (middle <= 0) {
        std::erase_if(luminances, [](float v) { return v <= 0; });
        middle = median(luminances);
    }
    FlipExposures range;
    range.start = std::log2(acesInverse(shown) / largest);
    range.stop = std::min(std::log2(acesInverse(shown) / middle), range.start + mostStops);
    range.count = static_cast<std::uint32_t>(std::max(2.0, std::ceil(range.stop - range.start)));
    return range;
}

}  // namespace vkpt
