// PNG and JPEG of every kind, made here by the same libraries' encoders.
#include "gltf/images.h"

#include <algorithm>
#include <array>

#include "builder.h"
#include "encode_jpeg.h"
#include "encode_png.h"

namespace vkpt::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::span<const std::byte> asBytes(const ByteVector& bytes) { return std::as_bytes(std::span(bytes)); }

TextureImage png(const ByteVector& bytes) {
    std::string fault;
    TextureImage image = gltf::decodePng(asBytes(bytes), fault);
    EXPECT_EQ(fault, "");
    return image;
}

TextureImage jpeg(const ByteVector& bytes) {
    std::string fault;
    TextureImage image = gltf::decodeJpeg(asBytes(bytes), fault);
    EXPECT_EQ(fault, "");
    return image;
}

TEST(Png, RgbaRedInTheLowByteTopRowFirst) {
    const TextureImage image = png(encodePng({1, 2, 8, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, {1, 2, 3, 4, 5, 6, 7, 8}}));
    EXPECT_EQ(image.width, 1U);
    EXPECT_EQ(image.height, 2U);
    EXPECT_THAT(image.texels, ElementsAre(0x04030201U, 0x08070605U));
}

TEST(Png, RgbAndGreyBecomeOpaque) {
    EXPECT_THAT(png(encodePng({1, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, {1, 2, 3}})).texels, ElementsAre(0xff030201U));
    EXPECT_THAT(png(encodePng({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, {7}})).texels, ElementsAre(0xff070707U));
    EXPECT_THAT(png(encodePng({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA, {7, 9}})).texels, ElementsAre(0x09070707U));
    EXPECT_THAT(png(encodePng({2, 1, 1, SPNG_COLOR_TYPE_GRAYSCALE, {0x40}})).texels,
                ElementsAre(0xff000000U, 0xffffffffU));
}

TEST(Png, PaletteWithTransparency) {
    spng_plte palette{};
    palette.n_entries = 2;
    palette.entries[0] = {10, 20, 30, 255};
    palette.entries[1] = {40, 50, 60, 255};
    spng_trns transparency{};
    transparency.n_type3_entries = 1;
    transparency.type3_alpha[0] = 128;
    EXPECT_THAT(png(encodePng({2, 1, 8, SPNG_COLOR_TYPE_INDEXED, {1, 0}}, &palette, &transparency)).texels,
                ElementsAre(0xff3c3228U, 0x801e140aU));
}

// 0x00ff is 255/65535 = 0.99 of a step of 1/255: rounding gives 1 where dropping the low byte would give 0.
TEST(Png, SixteenBitsAreRounded) {
    const std::vector<std::uint8_t> samples = {0x00, 0xff, 0x00, 0x80, 0xff, 0x7f, 0xff, 0xff};
    EXPECT_THAT(png(encodePng({1, 1, 16, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, samples})).texels, ElementsAre(0xffff0001U));
}

TEST(Png, BrokenOnesSayWhy) {
    const ByteVector whole = encodePng({2, 2, 8, SPNG_COLOR_TYPE_GRAYSCALE, {1, 2, 3, 4}});
    for (std::size_t size = 8; size + 20 < whole.size(); ++size) {  // the checksums and IEND may be missing
        std::string fault;
        const TextureImage image = gltf::decodePng(asBytes(whole).first(size), fault);
        EXPECT_TRUE(image.texels.empty()) << size;
        EXPECT_THAT(fault, HasSubstr("broken PNG"));
    }
}

TEST(Png, HeadersThatPromiseTooMuchAreRefusedBeforeAnythingIsAllocated) {
    ByteVector bytes = encodePng({2, 2, 8, SPNG_COLOR_TYPE_GRAYSCALE, {1, 2, 3, 4}});
    bytes[17] = bytes[21] = 0x40;  // 2^22 wide and high
    std::string fault;
    EXPECT_TRUE(gltf::decodePng(asBytes(bytes), fault).texels.empty());
    EXPECT_NE(fault, "");

    // Honest checksum, dishonest size: 16384 x 16384 in 70 bytes.
    ByteVector small = encodePng({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, {1}});
    const ByteVector wide = encodePng({16384, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, std::vector<std::uint8_t>(16384)});
    std::copy(wide.begin() + 8, wide.begin() + 33, small.begin() + 8);  // the IHDR chunk
    fault.clear();
    EXPECT_TRUE(gltf::decodePng(asBytes(small), fault).texels.empty());
    EXPECT_NE(fault, "");
}

void expectTexel(std::uint32_t texel, int r, int g, int b, int tolerance) {
    EXPECT_NEAR(static_cast<int>(texel & 255U), r, tolerance);
    EXPECT_NEAR(static_cast<int>(texel >> 8 & 255U), g, tolerance);
    EXPECT_NEAR(static_cast<int>(texel >> 16 & 255U), b, tolerance);
    EXPECT_EQ(texel >> 24, 255U);
}

template <std::size_t n>
std::vector<std::uint8_t> repeat(const std::array<std::uint8_t, n>& pixel, std::size_t count) {
    std::vector<std::uint8_t> samples;
    for (std::size_t i = 0; i < count; ++i) samples.insert(samples.end(), pixel.begin(), pixel.end());
    return samples;
}

TEST(Jpeg, ColourGreyProgressive) {
    const auto rgb = repeat<3>({200, 100, 50}, 64);
    const auto grey = repeat<1>({90}, 64);
    const TextureImage image = jpeg(encodeJpeg(8, 8, 3, JCS_RGB, rgb));
    ASSERT_EQ(image.texels.size(), 64U);
    expectTexel(image.texels[27], 200, 100, 50, 3);
    expectTexel(jpeg(encodeJpeg(8, 8, 3, JCS_RGB, rgb, true)).texels[0], 200, 100, 50, 3);
    expectTexel(jpeg(encodeJpeg(8, 8, 1, JCS_GRAYSCALE, grey)).texels[63], 90, 90, 90, 1);
}

TEST(Jpeg, TopRowFirst) {
    auto samples = repeat<1>({0}, 16 * 8);
    std::fill(samples.begin(), samples.begin() + 64, std::uint8_t{255});
    const TextureImage image = jpeg(encodeJpeg(8, 16, 1, JCS_GRAYSCALE, samples));
    expectTexel(image.texels[0], 255, 255, 255, 2);
    expectTexel(image.texels[127], 0, 0, 0, 2);
}

// libjpeg marks its CMYK files as Adobe's, which store paper, not ink: 255 is none.
TEST(Jpeg, CmykBecomesRgb) {
    expectTexel(jpeg(encodeJpeg(8, 8, 4, JCS_CMYK, repeat<4>({255, 128, 0, 255}, 64))).texels[0], 255, 128, 0, 3);
    expectTexel(jpeg(encodeJpeg(8, 8, 4, JCS_CMYK, repeat<4>({255, 255, 255, 51}, 64))).texels[0], 51, 51, 51, 3);
}

TEST(Jpeg, EveryTruncationIsAFault) {
    for (const bool progressive : {false, true}) {
        const ByteVector whole = encodeJpeg(32, 32, 3, JCS_RGB, repeat<3>({9, 99, 199}, 1024), progressive);
        for (std::size_t size = 3; size + 2 < whole.size(); ++size) {
            std::string fault;
            EXPECT_TRUE(gltf::decodeJpeg(asBytes(whole).first(size), fault).texels.empty()) << size;
            EXPECT_THAT(fault, HasSubstr("broken JPEG")) << size;
        }
    }
}

TEST(Jpeg, BytesAfterTheLastMarkerDoNoHarm) {
    ByteVector bytes = encodeJpeg(8, 8, 1, JCS_GRAYSCALE, repeat<1>({90}, 64));
    bytes.insert(bytes.end(), {1, 2, 3});
    std::string fault;
    EXPECT_EQ(gltf::decodeJpeg(asBytes(bytes), fault).texels.size(), 64U);
}

TEST(Jpeg, HugeSizesInFewBytesAreNotBelieved) {
    ByteVector bytes = encodeJpeg(8, 8, 1, JCS_GRAYSCALE, repeat<1>({90}, 64));
    constexpr std::array<std::uint8_t, 2> kFrameMarker = {0xff, 0xc0};
    const auto frame = std::search(bytes.begin(), bytes.end(), kFrameMarker.begin(), kFrameMarker.end());
    for (std::ptrdiff_t i = 5; i < 9; i += 2) frame[i] = 0x3f;  // 16136 x 16136
    std::string fault;
    EXPECT_TRUE(gltf::decodeJpeg(asBytes(bytes), fault).texels.empty());
    EXPECT_THAT(fault, HasSubstr("not believable"));
}

TEST(Jpeg, FlippedBytesNeverCrash) {
    const ByteVector whole = encodeJpeg(32, 32, 3, JCS_RGB, repeat<3>({9, 99, 199}, 1024));
    // A flipped size is honoured as far as the limit goes: leave those four bytes of the frame header alone, for speed.
    constexpr std::array<std::uint8_t, 2> kFrameMarker = {0xff, 0xc0};
    const auto frame = std::search(whole.begin(), whole.end(), kFrameMarker.begin(), kFrameMarker.end());
    const auto sizeAt = static_cast<std::size_t>(frame - whole.begin()) + 5;
    for (std::size_t i = 2; i < whole.size(); ++i) {
        if (i >= sizeAt && i < sizeAt + 4) continue;
        ByteVector bytes = whole;
        bytes[i] ^= 0x5a;
        std::string fault;
        (void)gltf::decodeJpeg(asBytes(bytes), fault);
    }
}

// ---- through a file -------------------------------------------------------------------------------------------

Builder withImage(const Json& image) {
    Builder b;
    b.triangle();
    b.textured(image);
    return b;
}

TEST(Images, FromBufferViewUriAndDataUri) {
    const ByteVector bytes = encodePng({1, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, {1, 2, 3}});
    Builder view;
    view.triangle();
    view.textured({{"bufferView", view.view(bytes)}, {"mimeType", "image/png"}, {"name", "paint"}});
    const Scene scene = view.import();
    EXPECT_THAT(scene.images.at(0).texels, ElementsAre(0xff030201U));
    EXPECT_EQ(scene.images[0].name, "paint");
    EXPECT_THAT(withImage({{"uri", "data:image/png;base64," + base64(bytes)}}).import().images.at(0).texels,
                ElementsAre(0xff030201U));
    const TemporaryFolder folder;
    folder.write("text ures/ä.png", bytes);
    const auto file = folder.write("s.gltf", withImage({{"uri", "text%20ures/%C3%A4.png"}}).text());
    EXPECT_THAT(importGltf(file).images.at(0).texels, ElementsAre(0xff030201U));
}

TEST(Images, TheBytesDecideNotTheMimeType) {
    const ByteVector bytes = encodeJpeg(8, 8, 1, JCS_GRAYSCALE, repeat<1>({90}, 64));
    EXPECT_EQ(withImage({{"uri", "data:image/png;base64," + base64(bytes)}}).import().images.at(0).width, 8U);
}

TEST(Images, Faults) {
    EXPECT_THAT(faultOf(withImage({{"uri", "gone.png"}})), HasSubstr("scene.gltf: images[0]: gone.png: no such file"));
    EXPECT_THAT(faultOf(withImage({{"uri", "../x.png"}})),
                HasSubstr("images[0]: uri \"../x.png\" leaves the scene's folder"));
    EXPECT_THAT(faultOf(withImage({{"uri", "data:image/webp,RIFF"}})), HasSubstr("images[0]: is neither PNG nor JPEG"));
    EXPECT_THAT(faultOf(withImage({{"uri", "data:image/png,%89PNG"}})), HasSubstr("images[0]: broken PNG"));
    EXPECT_THAT(faultOf(withImage(Json::object())), HasSubstr("images[0]: has neither uri nor bufferView"));
}

TEST(Images, ThoseThatNothingUsesAreNotEvenOpened) {
    Builder b;
    b.triangle();
    b.push("images", {{"uri", "gone.png"}});
    EXPECT_TRUE(b.import().images.empty());
}

}  // namespace
}  // namespace vkpt::test
