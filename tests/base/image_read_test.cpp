#include "base/image_read.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/image_read_fixture.h"
#include "encode_png.h"

namespace vkpt {
namespace {

std::string bytesOf(std::initializer_list<int> values) {
    std::string s;
    for (const int v : values) s += static_cast<char>(v);
    return s;
}

template <typename T>
std::string rawOf(std::initializer_list<T> values) {
    std::string s;
    for (const T v : values) s.append(reinterpret_cast<const char*>(&v), sizeof v);
    return s;
}

/// A square PNG of one colour.
std::string plainPng(std::uint32_t side) {
    const auto png =
        encodePng({side, side, 8, SPNG_COLOR_TYPE_TRUECOLOR, std::vector<std::uint8_t>(side * side * 3, 'x')});
    return {png.begin(), png.end()};
}

// ---- files that are none --------------------------------------------------------------------------------------------

TEST_F(ImageRead, MissingFoldersAndForeignFilesAreFileErrors) {
    EXPECT_THROW((void)readImage(folder_ / "absent.hdr"), FileError);
    EXPECT_THROW((void)readImage(folder_.path()), FileError);
    expectFault("", "no image");
    expectFault("GIF89a", "no image");
}

TEST_F(ImageRead, ContentsTellTheKindNotTheName) {
    EXPECT_EQ(readImage(write("picture.png", "Pf\n1 1\n-1\n" + rawOf({2.5F}))).pixels, Pixels{2.5F});
}

// ---- Radiance -------------------------------------------------------------------------------------------------------

const std::string kHdr = "#?RADIANCE\n# made by a test\nFORMAT=32-bit_rle_rgbe\n\n";

TEST_F(ImageRead, HdrFlatPixels) {
    const Image image = readImage(write("a.hdr", kHdr + "-Y 1 +X 2\n" + bytesOf({128, 64, 0, 129, 9, 9, 9, 0})));
    EXPECT_EQ(image.width, 2U);
    EXPECT_EQ(image.channels, 3U);
    EXPECT_EQ(image.pixels, (Pixels{1, 0.5F, 0, 0, 0, 0}));  // exponent 0 is black
}

TEST_F(ImageRead, HdrOldRuns) {
    // (1,1,1,n) repeats; a second one in a row counts in units of 256.
    std::string bytes = bytesOf({128, 0, 0, 129, 1, 1, 1, 3, 1, 1, 1, 1, 0, 128, 0, 129});
    const Image image = readImage(write("a.hdr", kHdr + "-Y 1 +X 261\n" + bytes));
    for (std::size_t x = 0; x < 260; ++x) EXPECT_EQ(image.pixels[x * 3], 1) << x;
    EXPECT_EQ(image.pixels[260 * 3 + 1], 1);
}

TEST_F(ImageRead, HdrNewRuns) {
    std::string bytes = bytesOf({2, 2, 0, 8});
    bytes += bytesOf({136, 128});                           // red: a run of 8
    bytes += bytesOf({8, 0, 16, 32, 48, 64, 80, 96, 112});  // green: literals
    bytes += bytesOf({130, 128, 134, 0});                   // blue: two runs
    bytes += bytesOf({136, 129});                           // exponent
    const Image image = readImage(write("a.hdr", kHdr + "-Y 1 +X 8\n" + bytes));
    for (std::size_t x = 0; x < 8; ++x) {
        EXPECT_EQ(image.pixels[x * 3], 1);
        EXPECT_EQ(image.pixels[x * 3 + 1], static_cast<float>(x) / 8);
        EXPECT_EQ(image.pixels[x * 3 + 2], x < 2 ? 1 : 0);
    }
}

TEST_F(ImageRead, HdrOrientations) {
    // Four scanline pixels 1/4, 2/4, 3/4, 1 in file order; where do they land in row-major order from the top left?
    const std::string four = bytesOf({32, 0, 0, 129, 64, 0, 0, 129, 96, 0, 0, 129, 128, 0, 0, 129});
    const std::pair<const char*, Pixels> cases[] = {
        {"-Y 2 +X 2", {1, 2, 3, 4}}, {"+Y 2 +X 2", {3, 4, 1, 2}}, {"-Y 2 -X 2", {2, 1, 4, 3}},
        {"+Y 2 -X 2", {4, 3, 2, 1}}, {"+X 2 -Y 2", {1, 3, 2, 4}}, {"-X 2 +Y 2", {4, 2, 3, 1}},
    };
    for (const auto& [resolution, order] : cases) {
        const Image image = readImage(write("a.hdr", kHdr + resolution + "\n" + four));
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(image.pixels[i * 3] * 4, order[i]) << resolution << ' ' << i;
    }
    const Image tall = readImage(write("a.hdr", kHdr + "+X 1 -Y 4\n" + four));
    EXPECT_EQ(tall.height, 4U);
    EXPECT_EQ(tall.at(0, 3)[0], 1);
}

TEST_F(ImageRead, BrokenHdr) {
    expectFault("#?RADIANCE\nFORMAT=32-bit_rle_rgbe", "header");
    expectFault("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234", "xyze");
    expectFault(kHdr + "-Y one +X 2\n", "resolution");
    expectFault(kHdr + "-Y 2 +Y 2\n", "resolution");
    expectFault(kHdr + "-Y 0 +X 2\n", "empty");
    expectFault(kHdr + "-Y 4000000000 +X 4000000000\n", "too large");
    expectFault(kHdr + "-Y 16000 +X 16000\n" + bytesOf({2, 2, 62, 128, 255, 1}), "too early");
    expectFault(kHdr + "-Y 1 +X 8\n" + bytesOf({2, 2, 0, 8, 255, 1}), "run");
    expectFault(kHdr + "-Y 1 +X 8\n" + bytesOf({2, 2, 0, 8, 0, 1}), "run");
    expectFault(kHdr + "-Y 1 +X 8\n" + bytesOf({2, 2, 0, 9}), "length");
    expectFault(kHdr + "-Y 1 +X 4\n" + bytesOf({1, 1, 1, 4}), "run");  // nothing to repeat
}

// ---- PFM ------------------------------------------------------------------------------------------------------------

TEST_F(ImageRead, PfmOfEitherByteOrderFromTheBottomUp) {
    const Image image = readImage(write("a.pfm", "PF\n1 2\n-1.0\n" + rawOf({1.0F, 2.0F, 3.0F, -4.0F, 5.0F, 6.0F})));
    EXPECT_EQ(image.pixels, (Pixels{-4, 5, 6, 1, 2, 3}));
    std::string big = rawOf({__builtin_bswap32(std::bit_cast<std::uint32_t>(0.75F))});
    EXPECT_EQ(readImage(write("b.pfm", "Pf 1 1 1.0\n" + big)).pixels, Pixels{0.75F});
}

TEST_F(ImageRead, PfmKeepsNonFiniteValues) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const Image image = readImage(write("a.pfm", "PF\n1 1\n-1\n" + rawOf({nan, inf, -1.0F})));
    EXPECT_TRUE(std::isnan(image.pixels[0]));
    EXPECT_EQ(image.pixels[1], inf);
}

TEST_F(ImageRead, BrokenPfm) {
    expectFault("PF\n2 x\n-1\n", "header");
    expectFault("PF\n2 2\n0\n", "header");
    expectFault("PF", "header");
    expectFault("PF\n4000000 4000000\n-1\n", "header");
    expectFault("PF\n2 2\n-1\nshort", "too early");
}

// ---- PNG ------------------------------------------------------------------------------------------------------------

TEST_F(ImageRead, PngKindsKeepTheirEncodedValues) {
    const auto read = [&](const PngImage& image) { return readImage(folder_.write("a.png", encodePng(image))); };
    const Image rgb = read({2, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, {0, 51, 255, 1, 2, 3}});
    EXPECT_EQ(rgb.channels, 3U);
    EXPECT_EQ(rgb.pixels, (Pixels{0, 0.2F, 1, 1 / 255.0F, 2 / 255.0F, 3 / 255.0F}));
    EXPECT_EQ(read({1, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA, {255, 0, 0, 51}}).pixels, (Pixels{1, 0, 0, 0.2F}));
    const Image deep = read({1, 1, 16, SPNG_COLOR_TYPE_TRUECOLOR, {0x00, 0x01, 0x33, 0x33, 0xff, 0xff}});
    EXPECT_EQ(deep.pixels, (Pixels{1 / 65535.0F, 0.2F, 1}));
    EXPECT_EQ(read({1, 1, 8, SPNG_COLOR_TYPE_GRAYSCALE, {51}}).pixels, (Pixels{0.2F, 0.2F, 0.2F}));
}

TEST_F(ImageRead, BrokenPng) {
    std::string png = plainPng(64);
    expectFault(png.substr(0, 20), "PNG");
    expectFault(png.substr(0, png.size() / 2), "PNG");
    png[40] = static_cast<char>(png[40] ^ 0x55);
    expectFault(png, "PNG");
}

TEST_F(ImageRead, DamagedBytesNeverEndInAnythingButAFileError) {
    expectNoWorseThanAFault(plainPng(16));
    expectNoWorseThanAFault(kHdr + "-Y 2 +X 8\n" + bytesOf({2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 4,
                                                            2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 4}));
    expectNoWorseThanAFault("PF\n2 1\n-1\n" + rawOf({1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}));
}

}  // namespace
}  // namespace vkpt
