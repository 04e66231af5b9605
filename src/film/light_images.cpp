#include "film/light_images.h"

#include "base/math.h"
#include "film/exact_ratio.h"

namespace vkpt {
namespace {

double luminanceOfAll(const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channels)
        sum += double{luminance({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]})};
    return sum;
}

Image lightImage(const Film& film, std::uint32_t firstWord) {
    Image image(film.width, film.height, kLightWords);
    const std::uint32_t samples = film.samples();
    if (samples == 0) return image;
    for (std::size_t pixel = 0; pixel < film.sums.size(); ++pixel)
        for (std::size_t c = 0; c < kLightWords; ++c)
            image.pixels[pixel * kLightWords + c] = exactRatio(
                signedSumOf(film.layers[pixel * film.layout.words() + firstWord + c]), samples, kFilmFractionBits);
    return image;
}

std::vector<LightImage> lightImages(const Film& film, std::uint32_t firstWord, const std::vector<std::string>& names,
                                    const std::vector<std::string>& labels) {
    std::vector<LightImage> images;
    if (names.empty()) return images;
    const double all = luminanceOfAll(filmToImage(film));
    for (std::size_t i = 0; i < names.size(); ++i) {
        Image image = lightImage(film, firstWord + static_cast<std::uint32_t>(i) * kLightWords);
        const double own = luminanceOfAll(image);
        images.push_back({names[i], labels[i], std::move(image), all == 0 ? 0 : own / all});
    }
    return images;
}

}  // namespace

std::vector<LightImage> lengthImages(const Film& film) {
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < film.layout.light().lengths; ++i) names.push_back(lengthLayerName(i));
    return lightImages(film, film.layout.lengthWord(), names, names);
}

std::vector<LightImage> groupImages(const Film& film) {
    const std::vector<std::string>& groups = film.layout.light().groups;
    return lightImages(film, film.layout.groupWord(), groupLayerNames(groups), groups);
}

}  // namespace vkpt
