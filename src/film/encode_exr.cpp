#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <oneapi/tbb/global_control.h>

#include <cassert>
#include <cstring>

#include "film/encode.h"

namespace vkpt {
namespace {

/// Lets OpenEXR write into memory; it seeks back to fill in its table of offsets.
class MemoryStream final : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char data[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
        std::memcpy(bytes_.data() + position_, data, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    [[nodiscard]] Bytes take() { return std::move(bytes_); }

private:
    Bytes bytes_;
    std::size_t position_ = 0;
};

Imf::PixelType pixelType(const ExrChannel& channel) {
    return channel.type == ExrChannel::Type::Uint ? Imf::UINT : Imf::FLOAT;
}

Imf::Header headerOf(std::uint32_t width, std::uint32_t height, const ExrPart& part) {
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    header.compression() = Imf::ZIP_COMPRESSION;
    header.setType(Imf::SCANLINEIMAGE);
    if (!part.name.empty()) header.setName(part.name);
    for (const auto& [key, value] : part.metadata) header.insert(key, Imf::StringAttribute(value));
    for (const ExrChannel& channel : part.channels)
        header.channels().insert(channel.name, Imf::Channel(pixelType(channel)));
    return header;
}

Imf::FrameBuffer frameBufferOf(std::uint32_t width, const ExrPart& part) {
    Imf::FrameBuffer frame;
    for (const ExrChannel& channel : part.channels) {
        // OpenEXR takes a pointer it never writes through.
        char* base = static_cast<char*>(const_cast<void*>(channel.first));
        frame.insert(channel.name,
                     Imf::Slice(pixelType(channel), base, channel.pixelStride, channel.pixelStride * width));
    }
    return frame;
}

void useAllThreads() {
    const auto threads =
        oneapi::tbb::global_control::active_value(oneapi::tbb::global_control::max_allowed_parallelism);
    Imf::setGlobalThreadCount(static_cast<int>(threads));
}

}  // namespace

Bytes encodeExr(std::uint32_t width, std::uint32_t height, const std::vector<ExrPart>& parts) {
    assert(!parts.empty());
    useAllThreads();
    std::vector<Imf::Header> headers;
    for (const ExrPart& part : parts) headers.push_back(headerOf(width, height, part));
    MemoryStream stream;
    if (parts.size() == 1) {
        Imf::OutputFile file(stream, headers.front());
        file.setFrameBuffer(frameBufferOf(width, parts.front()));
        file.writePixels(static_cast<int>(height));
    } else {
        Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Imf::OutputPart output(file, static_cast<int>(i));
            output.setFrameBuffer(frameBufferOf(width, parts[i]));
            output.writePixels(static_cast<int>(height));
        }
    }  // the destructors complete the file
    return stream.take();
}

std::vector<ExrChannel> channelsOf(const Image& image, const std::vector<std::string>& names) {
    assert(names.size() == image.channels);
    std::vector<ExrChannel> channels;
    for (std::size_t c = 0; c < names.size(); ++c)
        channels.push_back(
            {names[c], ExrChannel::Type::Float, image.pixels.data() + c, image.channels * sizeof(float)});
    return channels;
}

Bytes encodeExr(const Image& linear, const ImageMetadata& metadata) {
    assert(linear.channels == 3 || linear.channels == 4);
    std::vector<std::string> names{"R", "G", "B", "A"};
    names.resize(linear.channels);
    return encodeExr(linear.width, linear.height, {{"", metadata, channelsOf(linear, names)}});
}

}  // namespace vkpt
