#include "plot/pixels.h"

#include <algorithm>

namespace vkpt {

void drawImage(Drawing& d, const Image& image, double x, double y, double width) {
    const double pixel = width / image.width;
    for (std::uint32_t j = 0; j < image.height; ++j) {
        for (std::uint32_t i = 0; i < image.width;) {
            const float* c = image.at(i, j);
            std::uint32_t end = i + 1;
            while (end < image.width && std::equal(c, c + 3, image.at(end, j))) ++end;
            d.box(x + i * pixel, y + j * pixel, (end - i) * pixel + 0.05, pixel + 0.05, {c[0], c[1], c[2]});
            i = end;
        }
    }
}

}  // namespace vkpt
