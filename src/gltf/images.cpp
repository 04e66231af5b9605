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
    const Json& object = document.item("images", index);
    const std::string place = fmt::format("images[{}]", index);
    const Json& uri = member(object, "uri");
    const Json& view = member(object, "bufferView");
    if (uri.is_null() && view.is_null()) document.fail("{}: has neither uri nor bufferView", place);

    Bytes loaded;
    std::span<const std::byte> bytes;
    if (!uri.is_null()) {
        loaded = document.readUri(uri.get_ref<const std::string&>(), place);
        bytes = loaded.view();
    } else {
        bytes = document.bufferView(view.get<std::size_t>());
    }

    // The bytes decide, not mimeType: files in the wild mislabel.
    TextureImage image;
    std::string fault;
    if (startsWith(bytes, {0x89, 'P', 'N', 'G'}))
        image = decodePng(bytes, fault);
    else if (startsWith(bytes, {0xFF, 0xD8, 0xFF}))
        image = decodeJpeg(bytes, fault);
    else
        fault = "is neither PNG nor JPEG";
    image.name = textOr(object, "name", "");
    if (image.texels.empty()) document.fail("{}: {}", place, fault);
    if (!fault.empty()) warnings.push_back(fmt::format("{}: {}", place, fault));
    return image;
}

}  // namespace vkpt::gltf
