#include "base/image_read.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "encode_png.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

class ImageRead : public ::testing::Test {
protected:
    fs::path write(const std::string& name, const std::string& bytes) const { return folder_.write(name, bytes); }
    void expectFault(const std::string& bytes, const std::string& part) const {
        try {
            (void)readImage(write("broken", bytes));
            ADD_FAILURE() << "read although: " << part;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("broken: "), std::string::npos) << error.what();
        }
    }
    TemporaryFolder folder_;
};

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

using Pixels = std::vector<float>;

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

// ---- OpenEXR --------------------------------------------------------------------------------------------------------

using Channels = std::vector<std::pair<std::string, Imf::PixelType>>;

/// Every channel holds 0, 1, 2, ... over the data window, plus 100 times its place in the list.
void writeExr(const fs::path& file, Imf::Header header, const Channels& channels) {
    const Imath::Box2i box = header.dataWindow();
    const int width = box.max.x - box.min.x + 1, height = box.max.y - box.min.y + 1;
    std::vector<std::vector<float>> floats;
    std::vector<std::vector<half>> halves;
    std::vector<std::vector<unsigned>> uints;
    Imf::FrameBuffer buffer;
    floats.reserve(9), halves.reserve(9), uints.reserve(9);
    for (std::size_t c = 0; c < channels.size(); ++c) {
        const auto& [name, type] = channels[c];
        header.channels().insert(name, Imf::Channel(type));
        floats.emplace_back(), halves.emplace_back(), uints.emplace_back();
        for (int i = 0; i < width * height; ++i) {
            const int value = i + 100 * static_cast<int>(c);
            floats.back().push_back(static_cast<float>(value));
            halves.back().emplace_back(static_cast<float>(value));
            uints.back().push_back(static_cast<unsigned>(value));
        }
        const auto insert = [&](auto& data) {
            buffer.insert(name, Imf::Slice::Make(type, data.data(), box, sizeof data[0],
                                                 sizeof data[0] * static_cast<std::size_t>(width)));
        };
        if (type == Imf::FLOAT) insert(floats.back());
        if (type == Imf::HALF) insert(halves.back());
        if (type == Imf::UINT) insert(uints.back());
    }
    if (header.hasTileDescription()) {
        Imf::TiledOutputFile out(file.c_str(), header);
        out.setFrameBuffer(buffer);
        out.writeTiles(0, out.numXTiles() - 1, 0, out.numYTiles() - 1);
    } else {
        Imf::OutputFile out(file.c_str(), header);
        out.setFrameBuffer(buffer);
        out.writePixels(height);
    }
}

TEST_F(ImageRead, ExrOfEveryChannelType) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
        writeExr(folder_ / "a.exr", Imf::Header(3, 2), {{"R", type}, {"G", type}, {"B", type}});
        const Image image = readImage(folder_ / "a.exr");
        ASSERT_EQ(image.pixels.size(), 18U);
        EXPECT_EQ(image.at(2, 1)[0], 5) << type;
        EXPECT_EQ(image.at(2, 1)[1], 105) << type;
        EXPECT_EQ(image.at(0, 0)[2], 200) << type;
    }
}

TEST_F(ImageRead, ExrChannelSets) {
    const auto read = [&](const std::vector<std::string>& names) {
        Channels channels;
        for (const std::string& name : names) channels.emplace_back(name, Imf::FLOAT);
        writeExr(folder_ / "a.exr", Imf::Header(2, 1), channels);
        return readImage(folder_ / "a.exr").pixels;
    };
    EXPECT_EQ(read({"A", "B", "G", "R", "Z"}), (Pixels{300, 200, 100, 0, 301, 201, 101, 1}));
    EXPECT_EQ(read({"Y"}), (Pixels{0, 1}));
    EXPECT_EQ(read({"A", "Y"}), (Pixels{100, 0, 101, 1}));
    EXPECT_EQ(read({"depth"}), (Pixels{0, 1}));
    EXPECT_EQ(read({"beauty.B", "beauty.G", "beauty.R"}), (Pixels{200, 100, 0, 201, 101, 1}));
    EXPECT_THROW(read({"u", "v"}), FileError);
}

TEST_F(ImageRead, ExrShowsTheDisplayWindow) {
    const Imath::Box2i display(Imath::V2i(0, 0), Imath::V2i(3, 2)), data(Imath::V2i(-1, 1), Imath::V2i(1, 4));
    writeExr(folder_ / "a.exr", Imf::Header(display, data), {{"Y", Imf::FLOAT}});
    // Data rows are 3 wide and begin at x = -1, y = 1: rows 0 and 1 of the data are rows 1 and 2 of the image.
    EXPECT_EQ(readImage(folder_ / "a.exr").pixels, (Pixels{0, 0, 0, 0, 1, 2, 0, 0, 4, 5, 0, 0}));
}

TEST_F(ImageRead, ExrCompressionsTilesAndManyBands) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        Imf::Header header(20, 600);
        header.compression() = compression;
        writeExr(folder_ / "a.exr", header, {{"Y", Imf::FLOAT}});
        EXPECT_EQ(readImage(folder_ / "a.exr").at(19, 599)[0], 11999) << compression;
        header.setTileDescription(Imf::TileDescription(16, 16));
        writeExr(folder_ / "a.exr", header, {{"Y", Imf::FLOAT}});
        EXPECT_EQ(readImage(folder_ / "a.exr").at(19, 599)[0], 11999) << compression;
    }
}

TEST_F(ImageRead, ExrLuminanceAndChroma) {
    std::vector<Imf::Rgba> pixels(16 * 16, Imf::Rgba(0.75F, 0.5F, 0.25F, 1));
    const Imath::Box2i window(Imath::V2i(2, 4), Imath::V2i(17, 19));
    {
        Imf::RgbaOutputFile out((folder_ / "a.exr").c_str(), Imf::Header(window, window), Imf::WRITE_YC);
        out.setFrameBuffer(pixels.data() - 2 - 4 * 16, 1, 16);
        out.writePixels(16);
    }
    const Image image = readImage(folder_ / "a.exr");
    EXPECT_EQ(image.channels, 3U);
    EXPECT_NEAR(image.at(8, 8)[0], 0.75F, 0.01F);
    EXPECT_NEAR(image.at(15, 15)[2], 0.25F, 0.01F);
}

TEST_F(ImageRead, ExrWithPartsGivesTheFirst) {
    std::vector<Imf::Header> headers;
    for (int i = 0; i < 2; ++i) {
        headers.emplace_back(2, 1);
        headers.back().setName("part" + std::to_string(i));
        headers.back().setType(Imf::SCANLINEIMAGE);
        headers.back().channels().insert("Y", Imf::Channel(Imf::FLOAT));
    }
    {
        Imf::MultiPartOutputFile file((folder_ / "a.exr").c_str(), headers.data(), 2);
        for (int i = 0; i < 2; ++i) {
            float values[] = {static_cast<float>(10 * i + 1), static_cast<float>(10 * i + 2)};
            Imf::FrameBuffer buffer;
            buffer.insert("Y",
                          Imf::Slice::Make(Imf::FLOAT, values, headers[0].dataWindow(), sizeof(float), sizeof values));
            Imf::OutputPart part(file, i);
            part.setFrameBuffer(buffer);
            part.writePixels(1);
        }
    }
    EXPECT_EQ(readImage(folder_ / "a.exr").pixels, (Pixels{1, 2}));
}

TEST_F(ImageRead, BrokenExr) {
    writeExr(folder_ / "a.exr", Imf::Header(64, 64), {{"R", Imf::FLOAT}, {"G", Imf::FLOAT}, {"B", Imf::FLOAT}});
    const std::string bytes = readText(folder_ / "a.exr");
    expectFault(bytes.substr(0, 4), "OpenEXR");
    expectFault(bytes.substr(0, 100), "OpenEXR");
    expectFault(bytes.substr(0, bytes.size() / 2), "OpenEXR");

    const Imath::Box2i huge(Imath::V2i(0, 0), Imath::V2i(200000, 200000)), small(Imath::V2i(0, 0), Imath::V2i(1, 1));
    writeExr(folder_ / "b.exr", Imf::Header(huge, small), {{"Y", Imf::FLOAT}});
    EXPECT_THROW((void)readImage(folder_ / "b.exr"), FileError);
}

// The library would allocate what these ask for before it found that the file holds less.
TEST_F(ImageRead, ExrHeadersThatAskForMoreThanTheFileHolds) {
    writeExr(folder_ / "a.exr", Imf::Header(64, 64), {{"Y", Imf::FLOAT}});
    const std::string good = readText(folder_ / "a.exr");
    const auto withValue = [&](const std::string& attribute, std::size_t offset, std::int32_t value) {
        std::string bytes = good;
        const std::size_t at = bytes.find(attribute) + attribute.size() + offset;
        return bytes.replace(at, sizeof value, reinterpret_cast<const char*>(&value), sizeof value);
    };
    const std::string compression("compression\0compression\0", 24), window("dataWindow\0box2i\0", 17);
    expectFault(withValue(compression, 0, 0x7fffffff), "an attribute states 2147483647 bytes");
    expectFault(withValue(compression, 0, -1), "an attribute states -1 bytes");
    expectFault(withValue(compression, 0, 2), "attribute 'compression': 2 bytes do not make a compression");
    expectFault(withValue(window, 16, 2000000), "64x2000001 pixels in");
    expectFault(withValue(window, 16, 60000), "3751 chunks in");
    expectFault(withValue(window, 16, -1), "the data window is empty");

    Imf::Header tiled(512, 512);
    tiled.setTileDescription(Imf::TileDescription(512, 512));
    {
        tiled.channels().insert("Y", Imf::Channel(Imf::HALF));
        Imf::TiledOutputFile out((folder_ / "b.exr").c_str(), tiled);
    }
    std::string bytes = readText(folder_ / "b.exr");
    const std::string tiles("tiles\0tiledesc\0", 15);
    bytes.replace(bytes.find(tiles) + tiles.size() + 4, 8, std::string("\1\0\0\0\1\0\0\0", 8));
    expectFault(bytes, "262144 chunks in");
}

TEST_F(ImageRead, DamagedBytesNeverEndInAnythingButAFileError) {
    writeExr(folder_ / "a.exr", Imf::Header(16, 16), {{"R", Imf::HALF}, {"G", Imf::HALF}, {"B", Imf::HALF}});
    const std::string samples[] = {readText(folder_ / "a.exr"), plainPng(16),
                                   kHdr + "-Y 2 +X 8\n" + bytesOf({2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 4,
                                                                   2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 4}),
                                   "PF\n2 1\n-1\n" + rawOf({1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F})};
    std::uint32_t random = 1;
    for (const std::string& sample : samples) {
        for (int round = 0; round < 100; ++round) {
            std::string bytes = sample;
            for (int k = 0; k < 3; ++k) {
                random = random * 1664525U + 1013904223U;
                bytes[(random >> 8U) % bytes.size()] = static_cast<char>(random >> 24U);
            }
            try {
                (void)readImage(write("damaged", bytes));
            } catch (const FileError&) {
                continue;  // the one accepted complaint: anything else fails the test
            }
        }
    }
}

}  // namespace
}  // namespace vkpt
