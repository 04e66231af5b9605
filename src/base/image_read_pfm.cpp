// Portable float maps: a text header of three fields, then rows of floats from the bottom up.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

#include "base/error.h"
#include "base/image_formats.h"

namespace vkpt {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Takes one word and the single white space after it off the front.
std::string_view takeWord(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && !isSpace(text[end])) ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return word;
}

template <typename T>
bool parse(std::string_view word, T& value) {
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && stop == word.data() + word.size();
}

}  // namespace

Image decodePfm(const std::string& name, std::span<const std::uint8_t> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::uint32_t channels = takeWord(text) == "PF" ? 3 : 1;
    std::uint32_t width = 0, height = 0;
    float scale = 0;
    const bool sized = parse(takeWord(text), width) && parse(takeWord(text), height) && parse(takeWord(text), scale);
    if (!sized || width == 0 || height == 0 || scale == 0 || std::uint64_t{width} * height > kMostPixels) {
        throw FileError(name, "header: not 'PF', width, height and scale of a float map");
    }
    const std::uint64_t values = std::uint64_t{width} * height * channels;
    if (text.size() < values * sizeof(float)) throw FileError(name, "pixels: the file ends too early; copy it again");

    Image image(width, height, channels);
    const bool swap = (scale < 0) != (std::endian::native == std::endian::little);
    const std::size_t row = std::size_t{width} * channels;
    for (std::size_t i = 0; i < values; ++i) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, text.data() + i * sizeof bits, sizeof bits);
        if (swap) bits = __builtin_bswap32(bits);
        image.pixels[(height - 1 - i / row) * row + i % row] = std::bit_cast<float>(bits);
    }
    return image;
}

}  // namespace vkpt
