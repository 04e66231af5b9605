// OpenEXR files of every kind, read.
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

#include <cmath>

#include "base/image_read_fixture.h"

namespace vkpt {
namespace {

using Channels = std::vector<std::pair<std::string, Imf::PixelType>>;

/// Every channel holds 0, 1, 2, ... over the data window, plus 100 times its place in the list.
void writeExr(const std::filesystem::path& file, Imf::Header header, const Channels& channels) {
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

TEST_F(ImageRead, DamagedExrNeverEndsInAnythingButAFileError) {
    writeExr(folder_ / "a.exr", Imf::Header(16, 16), {{"R", Imf::HALF}, {"G", Imf::HALF}, {"B", Imf::HALF}});
    expectNoWorseThanAFault(readText(folder_ / "a.exr"));
}

}  // namespace
}  // namespace vkpt
