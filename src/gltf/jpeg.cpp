// JPEG through libjpeg-turbo's C interface.
#include <fmt/format.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <vector>
// jpeglib.h needs the three above.
#include <jpeglib.h>
// and this one jpeglib.h
#include <jerror.h>

#include "gltf/images.h"

namespace vkpt::gltf {
namespace {

// Progressive files may repeat scans without end; honest encoders write about ten.
constexpr int kMaxScans = 200;
// A block of 64 pixels takes a bit at the very least (arithmetic coding apart, which no exporter writes).
constexpr std::uint64_t kMostPixelsPerByte = 1024;

/// What libjpeg only warns of although pixels are missing or wrong.
bool losesPixels(int message) {
    switch (message) {
        case JWRN_ARITH_BAD_CODE:
        case JWRN_HIT_MARKER:
        case JWRN_HUFF_BAD_CODE:
        case JWRN_JPEG_EOF:
        case JWRN_MUST_RESYNC:
        case JWRN_NOT_SEQUENTIAL:
            return true;
        default:
            return false;
    }
}

/// A decompressor whose errors come back as `false` from step().
class JpegReader {
public:
    JpegReader() {
        info_.err = jpeg_std_error(&errors_);
        errors_.error_exit = onError;
        errors_.emit_message = onMessage;
        info_.client_data = this;
        jpeg_create_decompress(&info_);
        progress_.progress_monitor = onProgress;
        info_.progress = &progress_;
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&info_); }

    /// Runs calls into libjpeg. An error inside jumps back here, over `calls`, which must own nothing.
    template <typename Calls>
    [[nodiscard]] bool step(Calls&& calls) {
        if (setjmp(jump_) != 0) return false;
        calls(info_);
        return true;
    }

    [[nodiscard]] jpeg_decompress_struct& info() { return info_; }
    [[nodiscard]] long warnings() const { return errors_.num_warnings; }
    /// The text of the last error or warning.
    [[nodiscard]] std::string message() {
        if (tooManyScans_) return fmt::format("has more than {} scans", kMaxScans);
        char text[JMSG_LENGTH_MAX];
        errors_.format_message(reinterpret_cast<j_common_ptr>(&info_), text);
        return text;
    }

private:
    static void onError(j_common_ptr common) { std::longjmp(static_cast<JpegReader*>(common->client_data)->jump_, 1); }

    static void onMessage(j_common_ptr common, int level) {
        if (level >= 0) return;  // a trace
        auto* self = static_cast<JpegReader*>(common->client_data);
        if (losesPixels(self->errors_.msg_code)) onError(common);
        ++self->errors_.num_warnings;
    }

    static void onProgress(j_common_ptr common) {
        auto* self = static_cast<JpegReader*>(common->client_data);
        if (self->info_.input_scan_number <= kMaxScans) return;
        self->tooManyScans_ = true;
        onError(common);
    }

    jpeg_decompress_struct info_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf jump_{};
    bool tooManyScans_ = false;
};

// Reads all rows into `image`; the four channels are RGBA or, for CMYK, ink.
bool readRows(JpegReader& reader, TextureImage& image) {
    std::uint32_t* texels = image.texels.data();
    const std::size_t width = image.width;
    return reader.step([&](jpeg_decompress_struct& info) {
        while (info.output_scanline < info.output_height) {
            auto* row = reinterpret_cast<JSAMPROW>(texels + std::size_t{info.output_scanline} * width);
            jpeg_read_scanlines(&info, &row, 1);
        }
        jpeg_finish_decompress(&info);
    });
}

// Ink to light: each of red, green and blue is what its ink and black let through. Adobe stores paper, not ink.
void cmykToRgb(TextureImage& image, bool inverted) {
    for (std::uint32_t& texel : image.texels) {
        const std::uint32_t light = inverted ? texel : ~texel;
        const std::uint32_t black = light >> 24;
        std::uint32_t out = 0xff000000U;
        for (int shift = 0; shift < 24; shift += 8) out |= ((light >> shift & 255U) * black + 127U) / 255U << shift;
        texel = out;
    }
}

}  // namespace

TextureImage decodeJpeg(std::span<const std::byte> bytes, std::string& fault) {
    JpegReader reader;
    const auto broken = [&] {
        fault = "broken JPEG: " + reader.message();
        return TextureImage{};
    };
    const bool opened = reader.step([&](jpeg_decompress_struct& info) {
        jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        jpeg_read_header(&info, TRUE);
    });
    if (!opened) return broken();

    jpeg_decompress_struct& info = reader.info();
    const std::uint64_t pixels = std::uint64_t{info.image_width} * info.image_height;
    if (pixels > kMaxImagePixels || info.image_width > kMaxImageSide || info.image_height > kMaxImageSide) {
        fault = fmt::format("JPEG of {}x{} pixels is too large", info.image_width, info.image_height);
        return {};
    }
    if (pixels > bytes.size() * kMostPixelsPerByte) {
        fault = fmt::format("JPEG of {}x{} pixels in {} bytes is not believable", info.image_width, info.image_height,
                            bytes.size());
        return {};
    }
    const bool cmyk = info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
    info.out_color_space = cmyk ? JCS_CMYK : JCS_EXT_RGBA;
    if (!reader.step([](jpeg_decompress_struct& d) { jpeg_start_decompress(&d); })) return broken();

    TextureImage image{.name = {},
                       .width = info.image_width,
                       .height = info.image_height,
                       .texels = std::vector<std::uint32_t>(pixels)};
    if (!readRows(reader, image)) return broken();
    if (cmyk) cmykToRgb(image, info.saw_Adobe_marker);
    if (reader.warnings() > 0) fault = "JPEG: " + reader.message();
    return image;
}

}  // namespace vkpt::gltf
