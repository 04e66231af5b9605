// Radiance pictures (RGBE). [Ward 91]
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/image_formats.h"

namespace vkpt {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

class Reader {
public:
    Reader(const std::string& name, std::span<const std::uint8_t> bytes) : name_(name), bytes_(bytes) {}

    [[noreturn]] void fail(const std::string& fault) const { throw FileError(name_, fault); }
    [[nodiscard]] std::uint8_t byte() {
        if (next_ >= bytes_.size()) fail("pixels: the file ends too early; copy it again");
        return bytes_[next_++];
    }
    [[nodiscard]] Rgbe pixel() {
        Rgbe value{};
        for (std::uint8_t& v : value) v = byte();
        return value;
    }
    [[nodiscard]] std::string_view line() {
        const std::size_t begin = next_;
        while (next_ < bytes_.size() && bytes_[next_] != '\n') ++next_;
        if (next_ >= bytes_.size()) fail("header: has no end; not a Radiance picture");
        const auto* text = reinterpret_cast<const char*>(bytes_.data());
        return {text + begin, next_++ - begin};
    }
    [[nodiscard]] std::size_t position() const { return next_; }
    void rewind(std::size_t position) { next_ = position; }

private:
    const std::string& name_;
    std::span<const std::uint8_t> bytes_;
    std::size_t next_ = 0;
};

/// The resolution line: scanlines run along the second axis, the first one says which scanline comes next.
struct Orientation {
    std::uint32_t scanlines = 0, length = 0;
    bool columns = false;  // scanlines are columns of the image
    bool flipScanlines = false, flipLength = false;
};

std::optional<std::uint32_t> parseAxis(std::string_view& text, char& sign, char& axis) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    if (text.size() < 4 || text[2] != ' ') return std::nullopt;
    sign = text[0];
    axis = text[1];
    text.remove_prefix(3);
    std::uint32_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return value;
}

Orientation parseResolution(const Reader& reader, std::string_view line) {
    char signs[2] = {}, axes[2] = {};
    const auto first = parseAxis(line, signs[0], axes[0]), second = parseAxis(line, signs[1], axes[1]);
    const bool rows = axes[0] == 'Y' && axes[1] == 'X', columns = axes[0] == 'X' && axes[1] == 'Y';
    if (!first || !second || !(rows || columns)) reader.fail("header: no resolution such as '-Y 512 +X 1024'");
    if (*first == 0 || *second == 0 || std::uint64_t{*first} * *second > kMostPixels) {
        reader.fail("header: the picture is empty or too large");
    }
    // Rows run from the top where Y decreases; columns from the left where X increases.
    const bool flipFirst = signs[0] == (rows ? '+' : '-'), flipSecond = signs[1] == (rows ? '-' : '+');
    return {*first, *second, columns, flipFirst, flipSecond};
}

Orientation parseHeader(Reader& reader) {
    std::string_view line = reader.line();
    while (!line.empty() && line != "\r") {
        if (line.starts_with("FORMAT=") && !line.starts_with("FORMAT=32-bit_rle_rgbe")) {
            reader.fail("header: " + std::string(line) + " is not supported; convert it to 32-bit_rle_rgbe");
        }
        line = reader.line();
    }
    return parseResolution(reader, reader.line());
}

/// The four components one after the other, each in runs (count > 128) and literals.
void readRuns(Reader& reader, std::vector<Rgbe>& scanline) {
    for (std::size_t c = 0; c < 4; ++c) {
        for (std::size_t x = 0; x < scanline.size();) {
            const std::uint8_t head = reader.byte();
            const std::size_t count = head > 128 ? head - 128U : head;
            if (count == 0 || x + count > scanline.size()) reader.fail("pixels: a run leaves its scanline");
            const std::uint8_t value = head > 128 ? reader.byte() : std::uint8_t{0};
            for (std::size_t i = 0; i < count; ++i) scanline[x++][c] = head > 128 ? value : reader.byte();
        }
    }
}

/// Plain pixels, in which (1, 1, 1, n) repeats the last one n times; in a row they are the digits of a larger n.
void readFlat(Reader& reader, std::vector<Rgbe>& scanline) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < scanline.size();) {
        const Rgbe value = reader.pixel();
        if (value[0] != 1 || value[1] != 1 || value[2] != 1) {
            scanline[x++] = value;
            shift = 0;
            continue;
        }
        const std::size_t count = shift < 32 ? std::size_t{value[3]} << shift : scanline.size();
        if (x == 0 || count > scanline.size() - x) reader.fail("pixels: a run leaves its scanline");
        for (std::size_t i = 0; i < count; ++i, ++x) scanline[x] = scanline[x - 1];
        shift += 8;
    }
}

void readScanline(Reader& reader, std::vector<Rgbe>& scanline) {
    const std::size_t start = reader.position();
    const Rgbe head = reader.pixel();
    const bool marked =
        head[0] == 2 && head[1] == 2 && head[2] < 128 && scanline.size() >= 8 && scanline.size() < 32768;
    if (!marked) {
        reader.rewind(start);
        readFlat(reader, scanline);
        return;
    }
    if ((std::size_t{head[2]} << 8U | head[3]) != scanline.size()) reader.fail("pixels: a scanline has another length");
    readRuns(reader, scanline);
}

}  // namespace

Image decodeHdr(const std::string& name, std::span<const std::uint8_t> bytes) {
    Reader reader(name, bytes);
    const Orientation o = parseHeader(reader);
    std::vector<Rgbe> scanline(o.length), all;
    for (std::uint32_t s = 0; s < o.scanlines; ++s) {  // grows with the file: a short one fails early
        readScanline(reader, scanline);
        all.insert(all.end(), scanline.begin(), scanline.end());
    }

    Image image(o.columns ? o.scanlines : o.length, o.columns ? o.length : o.scanlines, 3);
    for (std::uint32_t s = 0; s < o.scanlines; ++s) {
        for (std::uint32_t i = 0; i < o.length; ++i) {
            const std::uint32_t a = o.flipScanlines ? o.scanlines - 1 - s : s, b = o.flipLength ? o.length - 1 - i : i;
            const Rgbe& source = all[std::size_t{s} * o.length + i];
            float* pixel = o.columns ? image.at(a, b) : image.at(b, a);
            const float scale = source[3] == 0 ? 0.0F : std::ldexp(1.0F, source[3] - 136);
            for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<float>(source[c]) * scale;
        }
    }
    return image;
}

}  // namespace vkpt
