#include "base/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>

#include "base/error.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kMultiPart = 0x1000;  // flag in the version field
// Rows a chunk, by the number of the compression: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB.
constexpr std::array<std::int64_t, 10> kChunkRows{1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
constexpr std::uint64_t kOffsetBytes = 8;  // of a chunk in the table of chunks
constexpr std::size_t kMostLetters = 255;  // of a name: where the library stops looking for its end

struct FixedType {
    std::string_view name;
    std::size_t size;
};
// The library reads these without regard to the size that the attribute states, and so may lose its place.
constexpr std::array kFixedTypes{FixedType{"box2f", 16},
                                 FixedType{"box2i", 16},
                                 FixedType{"chromaticities", 32},
                                 FixedType{"compression", 1},
                                 FixedType{"deepImageState", 1},
                                 FixedType{"double", 8},
                                 FixedType{"envmap", 1},
                                 FixedType{"float", 4},
                                 FixedType{"int", 4},
                                 FixedType{"keycode", 28},
                                 FixedType{"lineOrder", 1},
                                 FixedType{"m33d", 72},
                                 FixedType{"m33f", 36},
                                 FixedType{"m44d", 128},
                                 FixedType{"m44f", 64},
                                 FixedType{"rational", 8},
                                 FixedType{"tiledesc", 9},
                                 FixedType{"timecode", 8},
                                 FixedType{"v2d", 16},
                                 FixedType{"v2f", 8},
                                 FixedType{"v2i", 8},
                                 FixedType{"v3d", 24},
                                 FixedType{"v3f", 12},
                                 FixedType{"v3i", 12}};

template <typename T>
T valueAt(std::span<const std::uint8_t> bytes, std::size_t offset) {
    T value{};
    if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

class Scan {
public:
    Scan(const std::string& name, std::span<const std::uint8_t> bytes) : name_(name), bytes_(bytes) {}

    void run() {
        constexpr std::size_t kMagicAndVersion = 8;
        const bool multiPart = (valueAt<std::uint32_t>(bytes_, 4) & kMultiPart) != 0;
        next_ = std::min(kMagicAndVersion, bytes_.size());
        do header();
        while (multiPart && next_ < bytes_.size() && bytes_[next_] != 0);
    }

private:
    struct Part {
        std::int64_t width = 0, height = 0;
        std::uint64_t tileWidth = 0, tileHeight = 0, chunks = 0;
        std::size_t compression = 0;
    };

    template <typename... Args>
    [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
        throw FileError(name_, "OpenEXR: " + fmt::format(text, std::forward<Args>(args)...));
    }

    std::string_view word() {
        const auto rest = bytes_.subspan(next_);
        const auto end = std::find(rest.begin(), rest.end(), std::uint8_t{0});
        if (end == rest.end()) fail("the file ends inside a header");
        const auto length = static_cast<std::size_t>(end - rest.begin());
        if (length > kMostLetters) fail("a name has more than {} letters", kMostLetters);
        next_ += length + 1;
        return {reinterpret_cast<const char*>(rest.data()), length};
    }

    /// Attributes up to an empty name: name, type, size, value.
    void header() {
        Part part;
        for (std::string_view attribute = word(); !attribute.empty(); attribute = word()) {
            const std::string_view type = word();
            const auto size = valueAt<std::int32_t>(bytes_, next_);
            next_ = std::min(next_ + sizeof size, bytes_.size());
            const std::size_t left = bytes_.size() - next_;
            if (size < 0 || static_cast<std::size_t>(size) > left)
                fail("an attribute states {} bytes, but {} are left", size, left);
            const auto value = bytes_.subspan(next_, static_cast<std::size_t>(size));
            if (!fits(type, value)) fail("attribute '{}': {} bytes do not make a {}", attribute, size, type);
            read(attribute, value, part);
            next_ += value.size();
        }
        check(part);
    }

    /// Whether the library, which goes by the type, reads as many bytes as the attribute has.
    static bool fits(std::string_view type, std::span<const std::uint8_t> value) {
        for (const FixedType& fixed : kFixedTypes)
            if (fixed.name == type) return fixed.size == value.size();
        if (type == "chlist") return isChannelList(value);
        if (type == "preview") {
            const auto pixels = std::uint64_t{valueAt<std::uint32_t>(value, 0)} * valueAt<std::uint32_t>(value, 4);
            return value.size() >= 8 && pixels == (value.size() - 8) / 4 && value.size() % 4 == 0;
        }
        return true;
    }

    /// Names, each with 16 bytes, up to an empty one.
    static bool isChannelList(std::span<const std::uint8_t> value) {
        constexpr std::ptrdiff_t kChannel = 16;
        auto at = value.begin();
        while (at != value.end() && *at != 0) {
            const auto end = std::find(at, value.end(), std::uint8_t{0});
            if (end - at > static_cast<std::ptrdiff_t>(kMostLetters) || value.end() - end <= kChannel) return false;
            at = end + 1 + kChannel;
        }
        return at != value.end() && at + 1 == value.end();
    }

    static void read(std::string_view attribute, std::span<const std::uint8_t> value, Part& part) {
        if (attribute == "dataWindow") {
            const auto side = [&](std::size_t axis) {
                return std::int64_t{valueAt<std::int32_t>(value, 8 + axis)} - valueAt<std::int32_t>(value, axis) + 1;
            };
            part.width = side(0);
            part.height = side(4);
        } else if (attribute == "tiles") {
            part.tileWidth = valueAt<std::uint32_t>(value, 0);
            part.tileHeight = valueAt<std::uint32_t>(value, 4);
        } else if (attribute == "compression") {
            part.compression = std::min<std::size_t>(valueAt<std::uint8_t>(value, 0), kChunkRows.size() - 1);
        } else if (attribute == "chunkCount") {
            part.chunks = valueAt<std::uint32_t>(value, 0);
        }
    }

    void check(Part& part) const {
        if (part.width <= 0 || part.height <= 0) fail("the data window is empty");
        const auto width = static_cast<std::uint64_t>(part.width), height = static_cast<std::uint64_t>(part.height);
        if (width > kExrFreePixels * kExrPixelsPerByte / height ||
            width * height > std::max(kExrFreePixels, bytes_.size() * kExrPixelsPerByte))
            fail("{}x{} pixels in {} bytes are not believable", width, height, bytes_.size());
        const auto rows = static_cast<std::uint64_t>(kChunkRows[part.compression]);
        std::uint64_t chunks = (height + rows - 1) / rows;
        if (part.tileWidth > 0 && part.tileHeight > 0)
            chunks = ((width - 1) / part.tileWidth + 1) * ((height - 1) / part.tileHeight + 1);
        chunks = std::max(chunks, part.chunks);
        if (chunks > bytes_.size() / kOffsetBytes)
            fail("{} chunks in {} bytes are not believable", chunks, bytes_.size());
    }

    const std::string& name_;
    std::span<const std::uint8_t> bytes_;
    std::size_t next_ = 0;
};

}  // namespace

void checkExrHeaders(const std::string& name, std::span<const std::uint8_t> bytes) { Scan(name, bytes).run(); }

}  // namespace vkpt
