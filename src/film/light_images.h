// Layers of light as images: of a film's integers, as the beauty is.
#pragma once
#include <string>
#include <vector>

#include "base/image.h"
#include "film/film.h"

namespace vkpt {

/// Light of one length or one group.
struct LightImage {
    std::string name;   ///< of its layer in a file
    std::string label;  ///< for people: a group's own name
    Image image;        ///< RGB, mean radiance of all samples: exact quotients, rounded once
    double share = 0;   ///< its luminance, over that of the whole picture; 0 where that is black
};

/// Empty where the film does not sort its light so.
[[nodiscard]] std::vector<LightImage> lengthImages(const Film& film);
[[nodiscard]] std::vector<LightImage> groupImages(const Film& film);

}  // namespace vkpt
