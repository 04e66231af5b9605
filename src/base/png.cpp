#include "base/png.h"

#include <fmt/format.h>
#include <spng.h>

#include <memory>

namespace vkpt {
namespace {

// Deflate packs at most 1032 bytes into one: a header that promises more than that is lying. [RFC 1951]
constexpr std::uint64_t kMostExpansion = 1032;
constexpr std::size_t kMostChunkBytes = std::size_t{64} << 20U;
constexpr std::uint32_t kMostSide = 0x7fffffff;

std::uint64_t packedBytes(const spng_ihdr& header) {
    constexpr unsigned kChannels[] = {1, 0, 3, 1,
                                      2, 0, 4};  // by colour type: grey, -, RGB, palette, grey + alpha, -, RGBA
    return std::uint64_t{header.width} * header.height * kChannels[header.color_type] * header.bit_depth / 8;
}

class Decoder {
public:
    Decoder(std::span<const std::uint8_t> bytes, PngPixels& pixels)
        : context_(spng_ctx_new(0), spng_ctx_free), bytes_(bytes), pixels_(pixels) {}

    /// Empty, or what went wrong.
    std::string run() {
        open();
        if (!failed() && !believable())
            return fmt::format("PNG of {}x{} pixels in {} bytes is not believable", header_.width, header_.height,
                               bytes_.size());
        if (!failed()) readRows();
        return failed() ? fmt::format("broken PNG: {}", spng_strerror(status_)) : std::string();
    }

private:
    [[nodiscard]] bool failed() const { return status_ != 0; }
    void step(int status) { status_ = failed() ? status_ : status; }

    void open() {
        step(context_ ? 0 : SPNG_EMEM);
        if (failed()) return;
        step(spng_set_image_limits(context_.get(), kMostSide, kMostSide));
        step(spng_set_chunk_limits(context_.get(), kMostChunkBytes, kMostChunkBytes));
        step(spng_set_crc_action(context_.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD));
        step(spng_set_png_buffer(context_.get(), bytes_.data(), bytes_.size()));
        step(spng_get_ihdr(context_.get(), &header_));
    }

    [[nodiscard]] bool believable() const {
        return std::uint64_t{header_.width} * header_.height <= kMostPngPixels &&
               packedBytes(header_) / kMostExpansion <= bytes_.size();
    }

    void readRows() {
        const bool wide = header_.bit_depth == 16;
        step(spng_decode_image(context_.get(), nullptr, 0, wide ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8,
                               SPNG_DECODE_TRNS | SPNG_DECODE_PROGRESSIVE));
        if (wide)
            readRows(pixels_.rgba16);
        else
            readRows(pixels_.rgba8);
        spng_trns transparency{};
        pixels_.alpha = (header_.color_type & 4U) != 0 || spng_get_trns(context_.get(), &transparency) == 0;
        pixels_.width = header_.width;
        pixels_.height = header_.height;
    }

    /// Rows come in order, or seven times over in an interlaced image.
    template <typename Sample>
    void readRows(std::vector<Sample>& samples) {
        const std::size_t row = std::size_t{header_.width} * 4;
        while (!failed()) {
            spng_row_info info{};
            step(spng_get_row_info(context_.get(), &info));
            const std::size_t end = row * (std::size_t{info.row_num} + 1);
            if (failed()) break;
            if (samples.size() < end) samples.resize(end);
            step(spng_decode_row(context_.get(), samples.data() + end - row, row * sizeof(Sample)));
        }
        if (status_ == SPNG_EOI) status_ = 0;
    }

    std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context_;
    std::span<const std::uint8_t> bytes_;
    PngPixels& pixels_;
    spng_ihdr header_{};
    int status_ = 0;
};

}  // namespace

PngPixels decodePng(std::span<const std::uint8_t> bytes, std::string& fault) {
    PngPixels pixels;
    fault = Decoder(bytes, pixels).run();
    return fault.empty() ? std::move(pixels) : PngPixels{};
}

}  // namespace vkpt
