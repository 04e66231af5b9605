// A film as an EXR file: picture, layers and the exact sums, a part each.
#pragma once
#include <vector>

#include "film/encode.h"
#include "film/film_record.h"
#include "film/layer_images.h"
#include "film/light_images.h"

namespace vkpt {

/// Everything of a film that a file may show.
struct FilmImages {
    Image beauty;  ///< RGBA
    std::vector<LayerImage> layers;
    std::vector<LightImage> lengths, groups;
};
[[nodiscard]] FilmImages filmImages(const Film& film);

/// Part "Combined" with channels R, G, B, A; a part for each AOV and each layer of light, named after it,
/// with channels such as albedo.R; with
/// `withFilm` the part vkpt.film. So Blender finds layers by part and Nuke by channel. A picture alone is a plain file
/// of one part. Layers and record must belong to the same film.
[[nodiscard]] Bytes encodeFilm(const FilmImages& images, const FilmRecord& record, bool withFilm,
                               const ImageMetadata& metadata);

}  // namespace vkpt
