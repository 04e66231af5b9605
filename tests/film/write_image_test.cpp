#include "film/write_image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spng.h>
#include <stb_image.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "base/error.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

class WriteImage : public testing::Test {
protected:
    [[nodiscard]] fs::path file(const char* name) const { return folder_ / name; }

    TemporaryFolder folder_;
};

/// 5 x 3, opaque, every value another.
Image gradient() {
    Image image(5, 3, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = i % 4 == 3 ? 1.0F : 0.01F + 0.015F * static_cast<float>(i);
    return image;
}

const WriteOptions kPlain{.display = {.toneMap = ToneMap::None}};

TEST_F(WriteImage, Png8RoundTrip) {
    const Image image = gradient();
    writeImage(file("a.png"), image, kPlain, {});
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> read(
        stbi_load(file("a.png").c_str(), &width, &height, &channels, 0), stbi_image_free);
    ASSERT_NE(read, nullptr) << stbi_failure_reason();
    ASSERT_EQ(width, 5);
    ASSERT_EQ(height, 3);
    ASSERT_EQ(channels, 3) << "an opaque picture has no alpha channel";
    for (std::uint32_t i = 0; i < 15; ++i)
        for (std::uint32_t c = 0; c < 3; ++c)
            EXPECT_EQ(read.get()[3 * i + c], std::lround(255 * srgbEncode(image.pixels[4 * i + c])));
}

TEST_F(WriteImage, Png8KeepsStraightAlpha) {
    Image image = gradient();
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] *= 0.5F;
    WriteOptions options = kPlain;
    options.display.transparent = true;
    writeImage(file("a.png"), image, options, {});
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> read(
        stbi_load(file("a.png").c_str(), &width, &height, &channels, 0), stbi_image_free);
    ASSERT_NE(read, nullptr);
    ASSERT_EQ(channels, 4);
    EXPECT_EQ(read.get()[3], 128);
    EXPECT_EQ(read.get()[4], std::lround(255 * srgbEncode(image.pixels[4] * 2)));
}

TEST_F(WriteImage, Png16RoundTrip) {
    const Image image = gradient();
    WriteOptions options = kPlain;
    options.pngBits = 16;
    writeImage(file("a.png"), image, options, {});
    const std::string bytes = readText(file("a.png"));
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
    ASSERT_EQ(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), 0);
    spng_ihdr header{};
    ASSERT_EQ(spng_get_ihdr(context.get(), &header), 0);
    EXPECT_EQ(header.bit_depth, 16);
    EXPECT_EQ(header.color_type, SPNG_COLOR_TYPE_TRUECOLOR);
    std::vector<std::uint16_t> values(5 * 3 * 3);
    ASSERT_EQ(spng_decode_image(context.get(), values.data(), values.size() * 2, SPNG_FMT_PNG, 0), 0);
    for (std::uint32_t i = 0; i < 15; ++i)
        for (std::uint32_t c = 0; c < 3; ++c)
            EXPECT_EQ(values[3 * i + c], std::lround(65535 * srgbEncode(image.pixels[4 * i + c])));
}

TEST_F(WriteImage, PngCarriesMetadata) {
    for (const int bits : {8, 16}) {
        WriteOptions options = kPlain;
        options.pngBits = bits;
        writeImage(file("a.png"), gradient(), options, {{"vkpt:spp", "64"}, {"vkpt:scene", "hélmet.glb"}});
        const std::string bytes = readText(file("a.png"));
        const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(0), spng_ctx_free);
        ASSERT_EQ(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), 0);
        std::uint8_t intent = 1;
        EXPECT_EQ(spng_get_srgb(context.get(), &intent), 0) << "tagged sRGB";
        std::uint32_t count = 0;
        ASSERT_EQ(spng_get_text(context.get(), nullptr, &count), 0);
        ASSERT_EQ(count, 2U);
        std::vector<spng_text> texts(count);
        ASSERT_EQ(spng_get_text(context.get(), texts.data(), &count), 0);
        EXPECT_STREQ(texts[0].keyword, "vkpt:spp");
        EXPECT_STREQ(texts[1].text, "hélmet.glb");
    }
}

TEST_F(WriteImage, ExrRoundTripIsExactAndCarriesMetadata) {
    Image image = gradient();
    image.at(4, 2)[0] = 12345.678F;
    image.at(0, 0)[3] = 0.3F;
    writeImage(file("a.exr"), image, kPlain, {{"vkpt:seed", "7"}});
    Imf::InputFile in(file("a.exr").c_str());
    const auto window = in.header().dataWindow();
    ASSERT_EQ(window.max.x, 4);
    ASSERT_EQ(window.max.y, 2);
    const auto* seed = in.header().findTypedAttribute<Imf::StringAttribute>("vkpt:seed");
    ASSERT_NE(seed, nullptr);
    EXPECT_EQ(seed->value(), "7");
    EXPECT_EQ(in.header().channels().findChannel("A")->type, Imf::FLOAT);
    Image read(5, 3, 4);
    Imf::FrameBuffer frame;
    const char* names[] = {"R", "G", "B", "A"};
    for (std::size_t c = 0; c < 4; ++c)
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read.pixels.data() + c), 16, 80));
    in.setFrameBuffer(frame);
    in.readPixels(0, 2);
    EXPECT_EQ(read.pixels, image.pixels);
}

TEST_F(WriteImage, HdrRoundTripWithinRgbePrecision) {
    const Image image = gradient();
    writeImage(file("a.hdr"), image, kPlain, {});
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<float, void (*)(void*)> read(stbi_loadf(file("a.hdr").c_str(), &width, &height, &channels, 3),
                                                       stbi_image_free);
    ASSERT_NE(read, nullptr);
    ASSERT_EQ(width, 5);
    for (std::uint32_t i = 0; i < 15; ++i) {
        const float peak = std::max({image.pixels[4 * i], image.pixels[4 * i + 1], image.pixels[4 * i + 2]});
        for (std::uint32_t c = 0; c < 3; ++c) EXPECT_NEAR(read.get()[3 * i + c], image.pixels[4 * i + c], peak / 127);
    }
}

TEST_F(WriteImage, HdrHasNoSignExrAndPfmKeepIt) {
    Image image(8, 1, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = i % 4 == 1 ? -0.25F : 0.5F;
    const Bytes hdr = encodeHdr(image);
    Image cut = image;
    for (float& value : cut.pixels) value = std::max(value, 0.0F);
    EXPECT_EQ(hdr, encodeHdr(cut));
    EXPECT_NE(encodePfm(image), encodePfm(cut));
    EXPECT_NE(encodeExr(image, {}), encodeExr(cut, {}));
}

TEST_F(WriteImage, PfmIsLittleEndianAndBottomUp) {
    const Image image = gradient();
    writeImage(file("a.PFM"), image, kPlain, {});
    const std::string bytes = readText(file("a.PFM"));
    const std::string header = "PF\n5 3\n-1.0\n";
    ASSERT_EQ(bytes.size(), header.size() + 5 * 3 * 3 * 4);
    EXPECT_EQ(bytes.substr(0, header.size()), header);
    float first = 0;
    std::memcpy(&first, bytes.data() + header.size(), 4);
    EXPECT_EQ(first, image.at(0, 2)[0]);
}

TEST_F(WriteImage, FailureNamesTheReasonAndLeavesNothing) {
    try {
        writeImage(folder_ / "absent" / "a.png", gradient(), kPlain, {});
        FAIL() << "no exception";
    } catch (const FileError& error) {
        EXPECT_EQ(error.code(), ExitCode::File);
        EXPECT_THAT(error.what(), testing::HasSubstr("absent/a.png: cannot write: No such file or directory"));
    }
    EXPECT_THROW(writeImage(file("a.bmp"), gradient(), kPlain, {}), FileError);
    EXPECT_TRUE(folder_.files().empty());
}

}  // namespace
}  // namespace vkpt
