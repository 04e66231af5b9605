#include <spng.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>

#include "base/error.h"
#include "film/encode.h"

namespace vkpt {
namespace {

/// Values in [0, 1] to integers of the whole range, rounded to nearest.
template <typename T>
std::vector<T> quantise(const std::vector<float>& values) {
    constexpr float kMaximum = std::numeric_limits<T>::max();
    std::vector<T> integers(values.size());
    std::transform(values.begin(), values.end(), integers.begin(),
                   [](float v) { return static_cast<T>(std::lround(v * kMaximum)); });
    return integers;
}

void check(int result) {
    if (result != SPNG_OK)
        throw Error(ExitCode::Internal, std::string("the PNG encoder failed: ") + spng_strerror(result));
}

/// UTF-8 text chunks as libspng takes them. It keeps the pointers: this must outlive the encoding.
class TextChunks {
public:
    explicit TextChunks(ImageMetadata metadata) : metadata_(std::move(metadata)) {
        for (auto& [key, value] : metadata_) {
            spng_text text{};
            key.copy(text.keyword, sizeof(text.keyword) - 1);
            text.type = SPNG_ITXT;
            text.length = value.size();
            text.text = value.data();
            text.language_tag = text.translated_keyword = empty_.data();
            chunks_.push_back(text);
        }
    }
    TextChunks(const TextChunks&) = delete;
    TextChunks& operator=(const TextChunks&) = delete;

    void set(spng_ctx* context) {
        if (!chunks_.empty()) check(spng_set_text(context, chunks_.data(), static_cast<std::uint32_t>(chunks_.size())));
    }

private:
    ImageMetadata metadata_;
    std::string empty_;
    std::vector<spng_text> chunks_;
};

template <typename T>
Bytes encode(const Image& display, const ImageMetadata& metadata) {
    TextChunks texts(metadata);
    const std::vector<T> values = quantise<T>(display.pixels);
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
    if (!context) throw std::bad_alloc();
    check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
    spng_ihdr header{};
    header.width = display.width;
    header.height = display.height;
    header.bit_depth = 8 * sizeof(T);
    header.color_type = display.channels == 4 ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA : SPNG_COLOR_TYPE_TRUECOLOR;
    check(spng_set_ihdr(context.get(), &header));
    check(spng_set_srgb(context.get(), 0));  // perceptual intent
    texts.set(context.get());
    check(spng_encode_image(context.get(), values.data(), values.size() * sizeof(T), SPNG_FMT_PNG,
                            SPNG_ENCODE_FINALIZE));
    std::size_t size = 0;
    int result = SPNG_OK;
    const std::unique_ptr<void, void (*)(void*)> buffer(spng_get_png_buffer(context.get(), &size, &result), std::free);
    check(result);
    const auto* first = static_cast<const std::byte*>(buffer.get());
    return Bytes(first, first + size);
}

}  // namespace

Bytes encodePng(const Image& display, int bits, const ImageMetadata& metadata) {
    assert((bits == 8 || bits == 16) && (display.channels == 3 || display.channels == 4));
    return bits == 8 ? encode<std::uint8_t>(display, metadata) : encode<std::uint16_t>(display, metadata);
}

}  // namespace vkpt
