#include "compare/perceptual.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/math.h"
#include "compare/channels.h"
#include "compare/ssim.h"
#include "film/tonemap.h"

namespace vkpt {
namespace {

struct Pair {
    Image image, reference;
};

/// The colour channels that face each other, black where one of the values is not finite.
Pair finiteColors(const Image& image, const Image& reference, const std::vector<ChannelPair>& colors) {
    const auto channels = static_cast<std::uint32_t>(colors.size());
    Pair pair{Image(image.width, image.height, channels), Image(image.width, image.height, channels)};
    oneapi::tbb::parallel_for(std::uint32_t{0}, image.height, [&](std::uint32_t y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const float *a = image.at(x, y), *r = reference.at(x, y);
            const bool finite = std::all_of(colors.begin(), colors.end(), [&](const ChannelPair& c) {
                return std::isfinite(a[c.image]) && std::isfinite(r[c.reference]);
            });
            for (std::uint32_t c = 0; c < channels; ++c) {
                pair.image.at(x, y)[c] = finite ? a[colors[c].image] : 0;
                pair.reference.at(x, y)[c] = finite ? r[colors[c].reference] : 0;
            }
        }
    });
    return pair;
}

/// Channel `c` alone.
Image channelOf(const Image& image, std::uint32_t c) {
    Image result(image.width, image.height, 1);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i] = image.pixels[i * image.channels + c];
    return result;
}

Pair channelsOf(const Pair& pair, std::uint32_t c) { return {channelOf(pair.image, c), channelOf(pair.reference, c)}; }

Image encoded(const Image& linear) {
    Image result = linear;
    oneapi::tbb::parallel_for(std::uint32_t{0}, result.height, [&](std::uint32_t y) {
        float* row = result.at(0, y);
        std::transform(row, row + std::size_t{result.width} * result.channels, row, srgbEncode);
    });
    return result;
}

Image lumaOf(const Image& color) {
    if (color.channels == 1) return color;
    Image result(color.width, color.height, 1);
    for (std::size_t i = 0; i < result.pixels.size(); ++i)
        result.pixels[i] = luminance({color.pixels[3 * i], color.pixels[3 * i + 1], color.pixels[3 * i + 2]});
    return result;
}

}  // namespace

PerceptualDifference comparePerceptually(const Image& image, const Image& reference, const PerceptualOptions& options) {
    std::vector<ChannelPair> colors = pairChannels(image, reference);
    std::erase_if(colors, [](const ChannelPair& c) { return !c.isColor; });
    const bool linear = !reference.displayEncoded;
    const Pair light = finiteColors(image, reference, colors);
    const Pair shown = linear ? Pair{encoded(light.image), encoded(light.reference)} : light;

    PerceptualDifference result;
    if (linear) result.flipExposures = flipExposures(light.reference);
    const auto flip = [&](const Pair& pair) {
        return linear ? hdrFlip(pair.image, pair.reference, result.flipExposures) : ldrFlip(pair.image, pair.reference);
    };
    result.ssim = ssim(lumaOf(shown.image), lumaOf(shown.reference));
    result.flip = flip(light);
    if (colors.size() == 1) return result;
    for (std::uint32_t c = 0; c < colors.size(); ++c) {
        const Pair channel = channelsOf(shown, c);
        const double flipMean =
            options.flipPerChannel ? flip(channelsOf(light, c)).mean : std::numeric_limits<double>::quiet_NaN();
        result.channels.push_back({colors[c].name, ssim(channel.image, channel.reference), flipMean});
    }
    return result;
}

}  // namespace vkpt
