// OpenEXR by its library.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/exr_header.h"
#include "base/exr_input.h"
#include "base/image_formats.h"

namespace vkpt {
namespace {

// Decoded at once: memory grows only as the file proves to hold pixels.
constexpr std::int64_t kBandRows = 256, kBandPixels = std::int64_t{1} << 20U;

struct Window {
    std::int64_t x0, y0, width, height;
    explicit Window(const Imath::Box2i& box)
        : x0(box.min.x),
          y0(box.min.y),
          width(std::int64_t{box.max.x} - box.min.x + 1),
          height(std::int64_t{box.max.y} - box.min.y + 1) {}
    [[nodiscard]] std::uint64_t pixels() const {
        return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    }
};

/// Names of the channels to read, in the order of the image's channels.
std::vector<std::string> pickChannels(const std::string& name, const Imf::ChannelList& list) {
    std::vector<std::string> names;
    for (auto c = list.begin(); c != list.end(); ++c) names.emplace_back(c.name());
    const auto has = [&](const std::string& n) { return std::find(names.begin(), names.end(), n) != names.end(); };
    std::vector<std::string> prefixes{""};
    for (const std::string& n : names) {
        if (n.ends_with(".R")) prefixes.push_back(n.substr(0, n.size() - 1));
    }
    for (const std::string& p : prefixes) {
        if (!has(p + "R") || !has(p + "G") || !has(p + "B")) continue;
        if (has(p + "A")) return {p + "R", p + "G", p + "B", p + "A"};
        return {p + "R", p + "G", p + "B"};
    }
    if (has("Y") && has("A")) return {"Y", "A"};
    if (has("Y")) return {"Y"};
    if (names.size() == 1) return names;
    std::string all;
    for (const std::string& n : names) all += " " + n;
    throw FileError(name, "OpenEXR: no R, G, B or Y among the channels" + all);
}

/// Copies rows of the data window into the display window.
class Placement {
public:
    Placement(const Window& data, const Window& display, std::uint32_t channels)
        : data_(data),
          display_(display),
          image_(static_cast<std::uint32_t>(display.width), static_cast<std::uint32_t>(display.height), channels) {}

    void copyRow(std::int64_t y, const float* row) {
        const std::int64_t target = y - display_.y0;
        if (target < 0 || target >= display_.height) return;
        const std::int64_t begin = std::max(data_.x0, display_.x0);
        const std::int64_t end = std::min(data_.x0 + data_.width, display_.x0 + display_.width);
        if (begin >= end) return;
        std::copy(row + (begin - data_.x0) * image_.channels, row + (end - data_.x0) * image_.channels,
                  image_.at(static_cast<std::uint32_t>(begin - display_.x0), static_cast<std::uint32_t>(target)));
    }
    Image take() { return std::move(image_); }

private:
    Window data_, display_;
    Image image_;
};

void checkWindows(const std::string& name, const Window& data, const Window& display) {
    const bool empty = data.width <= 0 || data.height <= 0 || display.width <= 0 || display.height <= 0;
    if (empty || data.pixels() > kMostPixels || display.pixels() > kMostPixels ||
        display.pixels() > std::max(kExrFreePixels, data.pixels() * 16)) {
        throw FileError(name, "OpenEXR: the data or display window is empty or too large");
    }
}

/// Decodes the data window as floats, a band after the other, before the image is made.
std::vector<float> readBands(Imf::InputPart& part, const Window& data, const std::vector<std::string>& channels) {
    std::vector<float> pixels;
    const std::size_t stride = channels.size() * sizeof(float),
                      rowBytes = stride * static_cast<std::size_t>(data.width);
    const std::int64_t bandRows = std::clamp<std::int64_t>(kBandPixels / data.width, 1, kBandRows);
    for (std::int64_t done = 0; done < data.height; done += bandRows) {
        const std::int64_t rows = std::min(bandRows, data.height - done);
        const std::size_t offset = pixels.size();
        pixels.resize(offset + rowBytes / sizeof(float) * static_cast<std::size_t>(rows));
        Imf::FrameBuffer target;
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const Imath::Box2i box(
                Imath::V2i(static_cast<int>(data.x0), static_cast<int>(data.y0 + done)),
                Imath::V2i(static_cast<int>(data.x0 + data.width - 1), static_cast<int>(data.y0 + done + rows - 1)));
            target.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, pixels.data() + offset + c, box, stride, rowBytes));
        }
        part.setFrameBuffer(target);
        part.readPixels(static_cast<int>(data.y0 + done), static_cast<int>(data.y0 + done + rows - 1));
    }
    return pixels;
}

/// Luminance with chroma at half resolution: the library rebuilds RGB.
std::vector<float> readLuminanceChroma(ExrInput& stream, const Window& data) {
    stream.seekg(0);
    Imf::RgbaInputFile file(stream);
    std::vector<Imf::Rgba> row(static_cast<std::size_t>(data.width));
    std::vector<float> pixels;
    for (std::int64_t y = data.y0; y < data.y0 + data.height; ++y) {
        // The base is that of pixel (0, 0), which need not lie in the row.
        file.setFrameBuffer(row.data() - data.x0, 1, 0);
        file.readPixels(static_cast<int>(y));
        for (const Imf::Rgba& p : row) pixels.insert(pixels.end(), {p.r, p.g, p.b});
    }
    return pixels;
}

Image decode(const std::string& name, ExrInput& stream) {
    Imf::MultiPartInputFile file(stream);
    const Imf::Header& header = file.header(0);
    if (header.hasType() && Imf::isDeepData(header.type())) {
        throw FileError(name, "OpenEXR: deep images are not supported; flatten it");
    }
    const Window data(header.dataWindow()), display(header.displayWindow());
    checkWindows(name, data, display);
    const bool chroma = header.channels().findChannel("RY") && header.channels().findChannel("BY");
    const std::vector<std::string> channels =
        chroma ? std::vector<std::string>{"R", "G", "B"} : pickChannels(name, header.channels());
    Imf::InputPart part(file, 0);
    const std::vector<float> pixels = chroma ? readLuminanceChroma(stream, data) : readBands(part, data, channels);
    Placement placement(data, display, static_cast<std::uint32_t>(channels.size()));
    for (std::int64_t y = 0; y < data.height; ++y) {
        placement.copyRow(data.y0 + y, pixels.data() + static_cast<std::size_t>(y * data.width) * channels.size());
    }
    return placement.take();
}

}  // namespace

Image decodeExr(const std::string& name, std::span<const std::uint8_t> bytes) {
    try {
        checkExrHeaders(name, bytes);
        ExrInput stream(name, bytes);
        return decode(name, stream);
    } catch (const Iex::BaseExc& fault) {
        throw FileError(name, std::string("OpenEXR: ") + fault.what());
    }
}

}  // namespace vkpt
