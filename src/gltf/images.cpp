#include "gltf/images.h"

#include <algorithm>

namespace vkpt::gltf {
namespace {

bool startsWith(std::span<const std::byte> bytes, std::initializer_list<unsigned> magic) {
    return bytes.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), bytes.begin(),
                      [](unsigned a, std::byte b) { return a == std::to_integer<unsigned>(b); });
}

}  // namespace

TextureImage loadImage(const Document& document, std::size_t index, std::vector<std::string>& warnings) {
    const tinygltf::Image& encoded = document.model().images[index];
    const std::string place = fmt::format("images[{}]", index);
    const bool inView = encoded.bufferView >= 0;
    const Bytes loaded = inView ? Bytes() : document.readUri(encoded.uri, place);
    const auto bytes =
        inView ? document.bufferView(static_cast<std::size_t>(encoded.bufferView)) : std::as_bytes(std::span(loaded));

    // The bytes decide, not mimeType: files in the wild mislabel.
    TextureImage image;
    std::string fault;
    if (startsWith(bytes, {0x89, 'P', 'N', 'G'}))
        image = decodePng(bytes, fault);
    else if (startsWith(bytes, {0xFF, 0xD8, 0xFF}))
        image = decodeJpeg(bytes, fault);
    else
        fault = "is neither PNG nor JPEG";
    image.name = encoded.name;
    if (image.texels.empty()) document.fail("{}: {}", place, fault);
    document.countImage(image.texels.size() * sizeof image.texels[0]);
    if (!fault.empty()) warnings.push_back(fmt::format("{}: {}", place, fault));
    return image;
}

}  // namespace vkpt::gltf
