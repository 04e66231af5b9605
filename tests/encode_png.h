// PNG files of every kind, for tests of what reads them.
#pragma once
#include <gtest/gtest.h>
#include <spng.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

namespace vkpt {

struct PngImage {
    std::uint32_t width = 1, height = 1;
    std::uint8_t depth = 8, colorType = SPNG_COLOR_TYPE_TRUECOLOR;
    std::vector<std::uint8_t> samples;  ///< as in the file: 16-bit ones big-endian
};

[[nodiscard]] inline std::vector<std::uint8_t> encodePng(const PngImage& image, const spng_plte* palette = nullptr,
                                                         const spng_trns* transparency = nullptr) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
    spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_ihdr header{};
    header.width = image.width;
    header.height = image.height;
    header.bit_depth = image.depth;
    header.color_type = image.colorType;
    spng_set_ihdr(context.get(), &header);
    spng_plte plte = palette != nullptr ? *palette : spng_plte{};
    spng_trns trns = transparency != nullptr ? *transparency : spng_trns{};
    if (palette != nullptr) spng_set_plte(context.get(), &plte);
    if (transparency != nullptr) spng_set_trns(context.get(), &trns);
    int error = spng_encode_image(context.get(), image.samples.data(), image.samples.size(), SPNG_FMT_RAW,
                                  SPNG_ENCODE_FINALIZE);
    EXPECT_EQ(error, 0) << spng_strerror(error);
    std::size_t size = 0;
    const std::unique_ptr<void, void (*)(void*)> data(spng_get_png_buffer(context.get(), &size, &error), std::free);
    const auto* first = static_cast<const std::uint8_t*>(data.get());
    return {first, first + size};
}

}  // namespace vkpt
