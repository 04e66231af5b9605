#include "film/encode.h"

#include <stb_image_write.h>

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cassert>

#include "base/error.h"

namespace vkpt {
namespace {

void append(Bytes& bytes, const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

std::vector<float> colorChannels(const Image& image) {
    assert(image.channels >= 3);
    std::vector<float> rgb;
    rgb.reserve(std::size_t{image.width} * image.height * 3);
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channels)
        rgb.insert(rgb.end(), {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
    return rgb;
}

}  // namespace

Bytes encodeHdr(const Image& linear) {
    std::vector<float> rgb = colorChannels(linear);
    for (float& value : rgb) value = std::max(value, 0.0F);  // the format has no sign
    Bytes bytes;
    const auto sink = [](void* context, void* data, int size) {
        append(*static_cast<Bytes*>(context), data, static_cast<std::size_t>(size));
    };
    if (stbi_write_hdr_to_func(sink, &bytes, static_cast<int>(linear.width), static_cast<int>(linear.height), 3,
                               rgb.data()) == 0)
        throw Error(ExitCode::Internal, "the HDR encoder failed");
    return bytes;
}

Bytes encodePfm(const Image& linear) {
    static_assert(std::endian::native == std::endian::little, "the scale -1 promises little endian");
    const std::vector<float> rgb = colorChannels(linear);
    const std::string header = fmt::format("PF\n{} {}\n-1.0\n", linear.width, linear.height);
    Bytes bytes;
    bytes.reserve(header.size() + rgb.size() * sizeof(float));
    append(bytes, header.data(), header.size());
    const std::size_t row = std::size_t{linear.width} * 3;
    for (std::size_t y = linear.height; y-- > 0;) append(bytes, rgb.data() + y * row, row * sizeof(float));
    return bytes;
}

}  // namespace vkpt
