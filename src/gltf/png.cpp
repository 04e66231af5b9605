// PNG to texels.
#include "base/png.h"

#include <cstring>

#include "gltf/images.h"

namespace vkpt::gltf {
namespace {

std::uint32_t roundTo8(std::uint16_t sample) { return (sample * 255U + 32767U) / 65535U; }

}  // namespace

TextureImage decodePng(std::span<const std::byte> bytes, std::string& fault) {
    const PngPixels pixels =
        vkpt::decodePng({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, fault);
    if (fault.empty() && (pixels.width > kMaxImageSide || pixels.height > kMaxImageSide))
        fault = fmt::format("PNG of {}x{} pixels is too large", pixels.width, pixels.height);
    if (!fault.empty()) return {};
    TextureImage image{.name = {}, .width = pixels.width, .height = pixels.height, .texels = {}};
    image.texels.resize(std::size_t{pixels.width} * pixels.height);
    if (!pixels.rgba8.empty()) std::memcpy(image.texels.data(), pixels.rgba8.data(), pixels.rgba8.size());
    for (std::size_t i = 0; i < pixels.rgba16.size(); ++i)
        image.texels[i / 4] |= roundTo8(pixels.rgba16[i]) << 8 * (i % 4);
    return image;
}

}  // namespace vkpt::gltf
