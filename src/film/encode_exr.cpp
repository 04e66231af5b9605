#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
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

}  // namespace

Bytes encodeExr(const Image& linear, const ImageMetadata& metadata) {
    assert(linear.channels == 3 || linear.channels == 4);
    constexpr std::array names{"R", "G", "B", "A"};
    Imf::Header header(static_cast<int>(linear.width), static_cast<int>(linear.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : metadata) header.insert(key, Imf::StringAttribute(value));

    Imf::FrameBuffer frame;
    const std::size_t pixelStride = linear.channels * sizeof(float), rowStride = pixelStride * linear.width;
    // OpenEXR takes a pointer it never writes through.
    char* base = reinterpret_cast<char*>(const_cast<float*>(linear.pixels.data()));
    for (std::size_t c = 0; c < linear.channels; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, base + c * sizeof(float), pixelStride, rowStride));
    }
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(linear.height));
    }  // the destructor completes the file
    return stream.take();
}

}  // namespace vkpt
