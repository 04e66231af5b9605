#include "film/layer_images.h"

#include <boost/multiprecision/cpp_int.hpp>

#include "film/exact_ratio.h"

namespace vkpt {
namespace {

using boost::multiprecision::uint256_t;

float meanOf(const uvec4& word, std::uint32_t paths) {
    if (paths == 0) return 0;
    return exactRatio(signedSumOf(word), paths, kFilmFractionBits);
}

uint256_t wide(U128 value) {
    return uint256_t(static_cast<std::uint64_t>(value >> 64U)) << 64U | static_cast<std::uint64_t>(value);
}

/// (n sum of squares - (sum)^2) / (n (n - 1)), the numerator exact: it cannot be negative.
float varianceOf(const uvec4& sums, const uvec4& squares, std::uint32_t samples) {
    const std::uint64_t n = samples - sums.w;  // without the paths left out
    if (n < 2) return 0;
    const uint256_t sum = wide(sumOf(sums)), numerator = n * wide(wideSumOf(squares)) - sum * sum;
    const double denominator = static_cast<double>(n) * static_cast<double>(n - 1);
    return static_cast<float>(
        std::ldexp(numerator.convert_to<double>() / denominator, -2 * static_cast<int>(kLuminanceFractionBits)));
}

/// The words of one pixel, and how many paths it is the sum of.
class PixelLayers {
public:
    PixelLayers(const Film& film, std::size_t pixel)
        : film_(film), sums_(film.sums[pixel]), words_(film.layers.data() + pixel * film.layout.words()) {}

    [[nodiscard]] std::uint32_t surfaces() const { return sums_.green.w; }
    [[nodiscard]] const uvec4& word(Layer layer, std::uint32_t i) const {
        return words_[film_.layout.firstWord(layer) + i];
    }
    [[nodiscard]] float coverage(std::uint32_t samples) const {
        return samples == 0 ? 0 : exactRatio(surfaces(), samples, 0);
    }

private:
    const Film& film_;
    const FilmSums& sums_;
    const uvec4* words_;
};

float channelOf(Aov aov, std::uint32_t channel, const PixelLayers& pixel, std::uint32_t samples) {
    switch (aov) {
        case Aov::Albedo:
            return meanOf(pixel.word(Layer::Albedo, channel), samples);
        case Aov::Normal:
            return meanOf(pixel.word(Layer::Normal, channel), samples);
        case Aov::Depth:
            return meanOf(pixel.word(Layer::Depth, channel), pixel.surfaces());
        case Aov::Position:
            return meanOf(pixel.word(Layer::Position, channel), pixel.surfaces());
        case Aov::Uv:
            return channel == 2 ? pixel.coverage(samples) : meanOf(pixel.word(Layer::Uv, channel), pixel.surfaces());
        case Aov::Alpha:
            return pixel.coverage(samples);
        default:
            return varianceOf(pixel.word(Layer::Luminance, 0), pixel.word(Layer::Luminance, 1), samples);
    }
}

bool isWhole(Aov aov) {
    return aov == Aov::Primitive || aov == Aov::Instance || aov == Aov::Material || aov == Aov::Samples;
}

std::uint32_t numberOf(Aov aov, const PixelLayers& pixel, std::uint32_t samples) {
    if (aov == Aov::Samples) return samples;
    const uvec4& ids = pixel.word(Layer::Ids, 0);
    return aov == Aov::Primitive ? ids.x : aov == Aov::Instance ? ids.y : ids.z;
}

LayerImage layerImage(const Film& film, const AovInfo& info) {
    const std::size_t pixels = film.sums.size();
    const auto channels = static_cast<std::uint32_t>(info.channels.size());
    LayerImage layer{info, isWhole(info.id), {}, {}};
    if (layer.isWhole) {
        layer.numbers.resize(pixels);
    } else {
        layer.image = Image(film.width, film.height, channels);
    }
    const std::uint32_t samples = film.samples();
    for (std::size_t i = 0; i < pixels; ++i) {
        const PixelLayers pixel(film, i);
        if (layer.isWhole) {
            layer.numbers[i] = numberOf(info.id, pixel, samples);
            continue;
        }
        for (std::uint32_t c = 0; c < channels; ++c)
            layer.image.pixels[i * channels + c] = channelOf(info.id, c, pixel, samples);
    }
    return layer;
}

}  // namespace

std::uint64_t pathsWithoutVariance(const Film& film) {
    std::uint64_t paths = 0;
    if (!film.layout.has(Layer::Luminance)) return paths;
    for (std::size_t i = film.layout.firstWord(Layer::Luminance); i < film.layers.size(); i += film.layout.words())
        paths += film.layers[i].w;
    return paths;
}

std::vector<LayerImage> layerImages(const Film& film) {
    std::vector<LayerImage> layers;
    for (const AovInfo& info : kAovs)
        if (film.layout.aovs().has(info.id)) layers.push_back(layerImage(film, info));
    return layers;
}

}  // namespace vkpt
