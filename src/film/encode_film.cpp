#include "film/encode_film.h"

#include <fmt/format.h>

#include "film/film_part.h"

namespace vkpt {
namespace {

ExrPart layerPart(const LayerImage& layer) {
    const std::string name(layer.aov.name);
    std::vector<std::string> channels;
    for (const char letter : layer.aov.channels) channels.push_back(fmt::format("{}.{}", name, letter));
    if (layer.isWhole)
        return {name, {}, {{channels.front(), ExrChannel::Type::Uint, layer.numbers.data(), sizeof(std::uint32_t)}}};
    return {name, {}, channelsOf(layer.image, channels)};
}

ExrPart layerPart(const LightImage& layer) {
    const auto channel = [&](char letter) { return fmt::format("{}.{}", layer.name, letter); };
    return {layer.name, {}, channelsOf(layer.image, {channel('R'), channel('G'), channel('B')})};
}

}  // namespace

FilmImages filmImages(const Film& film) {
    return {filmToImage(film), layerImages(film), lengthImages(film), groupImages(film)};
}

Bytes encodeFilm(const FilmImages& images, const FilmRecord& record, bool withFilm, const ImageMetadata& metadata) {
    std::vector<ExrPart> parts{{"Combined", metadata, channelsOf(images.beauty, {"R", "G", "B", "A"})}};
    for (const LayerImage& layer : images.layers) parts.push_back(layerPart(layer));
    for (const auto* light : {&images.lengths, &images.groups})
        for (const LightImage& layer : *light) parts.push_back(layerPart(layer));
    if (withFilm) parts.push_back(filmPart(record, metadata));
    if (parts.size() == 1) parts.front().name.clear();
    return encodeExr(images.beauty.width, images.beauty.height, parts);
}

}  // namespace vkpt
