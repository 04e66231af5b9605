// PNG through libspng.
#include <fmt/format.h>
#include <spng.h>

#include <memory>
#include <vector>

#include "gltf/images.h"

namespace vkpt::gltf {
namespace {

// Deflate packs at most 1032 bytes into one: a header that promises more than that is lying.
constexpr std::uint64_t kMaxDeflateRatio = 1032;
constexpr std::size_t kMaxChunkBytes = std::size_t{1} << 26;

std::uint32_t roundTo8(std::uint16_t sample) { return (sample * 255U + 32767U) / 65535U; }

std::uint64_t storedBits(const spng_ihdr& header) {
    constexpr int kChannels[] = {1, 0, 3, 1, 2, 0, 4};  // by colour type: grey, -, RGB, palette, grey + alpha, -, RGBA
    const int channels = header.color_type < std::size(kChannels) ? kChannels[header.color_type] : 0;
    return std::uint64_t{header.width} * header.height * static_cast<std::uint64_t>(channels) * header.bit_depth;
}

}  // namespace

TextureImage decodePng(std::span<const std::byte> bytes, std::string& fault) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
    spng_ihdr header{};
    spng_set_image_limits(context.get(), kMaxImageSide, kMaxImageSide);
    spng_set_chunk_limits(context.get(), kMaxChunkBytes, kMaxChunkBytes);
    spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD);
    int error = spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
    if (error == 0) error = spng_get_ihdr(context.get(), &header);
    if (error != 0) {
        fault = fmt::format("broken PNG: {}", spng_strerror(error));
        return {};
    }
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
    if (pixels > kMaxImagePixels || storedBits(header) / 8 > bytes.size() * kMaxDeflateRatio) {
        fault =
            fmt::format("PNG of {}x{} pixels in {} bytes is not believable", header.width, header.height, bytes.size());
        return {};
    }

    TextureImage image{
        .name = {}, .width = header.width, .height = header.height, .texels = std::vector<std::uint32_t>(pixels)};
    if (header.bit_depth == 16) {
        std::vector<std::uint16_t> wide(pixels * 4);
        error = spng_decode_image(context.get(), wide.data(), wide.size() * 2, SPNG_FMT_RGBA16, SPNG_DECODE_TRNS);
        for (std::uint64_t i = 0; i < pixels; ++i)
            image.texels[i] = roundTo8(wide[4 * i]) | roundTo8(wide[4 * i + 1]) << 8 | roundTo8(wide[4 * i + 2]) << 16 |
                              roundTo8(wide[4 * i + 3]) << 24;
    } else {
        error = spng_decode_image(context.get(), image.texels.data(), pixels * 4, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS);
    }
    if (error != 0) {
        fault = fmt::format("broken PNG: {}", spng_strerror(error));
        return {};
    }
    return image;
}

}  // namespace vkpt::gltf
