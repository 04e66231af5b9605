// PNG by libspng.
#include <spng.h>

#include <cstring>
#include <memory>
#include <vector>

#include "base/error.h"
#include "base/image_formats.h"

namespace vkpt {
namespace {

// Deflate cannot expand by more than this, so a larger claim is a lie. [RFC 1951]
constexpr std::uint64_t kMostExpansion = 1032;
constexpr std::size_t kMostChunkBytes = std::size_t{64} << 20U;

void check(const std::string& name, int status) {
    if (status != SPNG_OK) throw FileError(name, std::string("PNG: ") + spng_strerror(status));
}

bool hasAlpha(spng_ctx* context, const spng_ihdr& header) {
    spng_trns transparency{};
    return header.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
           header.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA || spng_get_trns(context, &transparency) == SPNG_OK;
}

unsigned samplesPerPixel(const spng_ihdr& header) {
    switch (header.color_type) {
        case SPNG_COLOR_TYPE_TRUECOLOR:
            return 3;
        case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
            return 4;
        case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
            return 2;
        default:
            return 1;
    }
}

}  // namespace

Image decodePng(const std::string& name, std::span<const std::uint8_t> bytes) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
    if (!context) throw FileError(name, "PNG: out of memory");
    check(name, spng_set_chunk_limits(context.get(), kMostChunkBytes, kMostChunkBytes));
    check(name, spng_set_png_buffer(context.get(), bytes.data(), bytes.size()));
    spng_ihdr header{};
    check(name, spng_get_ihdr(context.get(), &header));
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
    const std::uint64_t packed = pixels * samplesPerPixel(header) * header.bit_depth / 8;
    if (pixels > kMostPixels || packed / kMostExpansion > bytes.size()) {
        throw FileError(name, "PNG: the header promises more pixels than the file can hold");
    }

    const bool wide = header.bit_depth == 16;
    const int format = wide ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
    std::size_t size = 0;
    check(name, spng_decoded_image_size(context.get(), format, &size));
    std::vector<std::uint8_t> decoded(size);
    check(name, spng_decode_image(context.get(), decoded.data(), size, format, SPNG_DECODE_TRNS));

    const std::uint32_t channels = hasAlpha(context.get(), header) ? 4 : 3;
    Image image(header.width, header.height, channels);
    image.displayEncoded = true;
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < channels; ++c) {
            std::uint16_t value = decoded[i * 4 + c];
            if (wide) std::memcpy(&value, decoded.data() + (i * 4 + c) * 2, 2);
            image.pixels[i * channels + c] = static_cast<float>(value) / (wide ? 65535.0F : 255.0F);
        }
    }
    return image;
}

}  // namespace vkpt
