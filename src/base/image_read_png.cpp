// PNG to floats.
#include "base/error.h"
#include "base/image_formats.h"
#include "base/png.h"

namespace vkpt {
namespace {

template <typename Sample>
void scale(const std::vector<Sample>& rgba, float maximum, Image& image) {
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
        for (std::size_t c = 0; c < image.channels; ++c)
            image.pixels[i * image.channels + c] = static_cast<float>(rgba[i * 4 + c]) / maximum;
}

}  // namespace

Image decodePng(const std::string& name, std::span<const std::uint8_t> bytes) {
    std::string fault;
    const PngPixels pixels = decodePng(bytes, fault);
    if (!fault.empty()) throw FileError(name, fault);
    Image image(pixels.width, pixels.height, pixels.alpha ? 4 : 3);
    image.displayEncoded = true;
    scale(pixels.rgba8, 255, image);
    scale(pixels.rgba16, 65535, image);
    return image;
}

}  // namespace vkpt
