// The film in its file: what is written reads back bit for bit, by us and by anybody who follows README's description.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/image_read.h"
#include "film/encode_film.h"
#include "film/film_part.h"
#include "film/read_film.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kWidth = 5, kHeight = 3;

/// Random words wherever a file stores one.
FilmRecord randomRecord(AovSet aovs, std::uint32_t seed = 1, const LightLayers& light = {}) {
    std::mt19937 generator(seed);
    Film film(kWidth, kHeight, aovs, light);
    for (const FilmChannel& channel : filmChannels(film))
        for (std::size_t i = 0; i < film.sums.size(); ++i)
            *reinterpret_cast<std::uint32_t*>(const_cast<char*>(reinterpret_cast<const char*>(channel.first) +
                                                                i * channel.pixelStride)) = generator() & 0x7fffffffU;
    for (FilmSums& sums : film.sums) sums.green.w = 1 + generator() % 40;
    film.ranges = {{0, 32}, {48, 60}};
    film.refused = 7;
    film.refusedInLayers = 9;
    Json settings{{"size", "5x3"}, {"spp", 64}, {"seed", 3}, {"aov", aovsText(aovs)}};
    if (!light.empty()) settings.update({{"perBounce", light.lengths}, {"lightGroups", light.groups}});
    return {film, settings, {{{{0, 32}}, "cpu", "CPU reference", ""}, {{{48, 60}}, "vulkan", "llvmpipe", "Mesa"}}};
}

class FilmFile : public testing::Test {
protected:
    [[nodiscard]] fs::path write(const FilmRecord& record, bool withFilm = true) const {
        const fs::path file = folder_ / "film.exr";
        writeFileAtomically(file, encodeFilm(filmImages(record.film), record, withFilm, {{"vkpt:scene", "s"}}));
        return file;
    }
    /// Writes `part` in place of the film's own.
    [[nodiscard]] fs::path writePart(const ExrPart& part) const {
        const fs::path file = folder_ / "film.exr";
        const Image image(kWidth, kHeight, 4);
        writeFileAtomically(
            file, encodeExr(kWidth, kHeight, {{"Combined", {}, channelsOf(image, {"R", "G", "B", "A"})}, part}));
        return file;
    }
    void expectRefused(const fs::path& file, const char* reason) const {
        try {
            (void)readFilm(file);
            ADD_FAILURE() << "accepted, but " << reason;
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(),
                        testing::AllOf(testing::StartsWith(file.string() + ": "), testing::HasSubstr(reason)));
        }
    }

    TemporaryFolder folder_;
};

TEST_F(FilmFile, ReadsBackBitForBit) {
    for (const AovSet aovs : {AovSet{}, kAllAovs, *parseAovs("depth,variance")}) {
        const FilmRecord record = randomRecord(aovs), read = readFilm(write(record));
        ASSERT_EQ(read.film.sums.size(), record.film.sums.size());
        EXPECT_EQ(std::memcmp(read.film.sums.data(), record.film.sums.data(), 15 * sizeof(FilmSums)), 0);
        EXPECT_EQ(read.film.layers, record.film.layers);
        EXPECT_EQ(read.film.layout.aovs(), aovs);
        EXPECT_EQ(read.film.ranges, record.film.ranges);
        EXPECT_EQ(read.film.refused, 7U);
        EXPECT_EQ(read.film.refusedInLayers, 9U);
        EXPECT_EQ(read.settings, record.settings);
        EXPECT_EQ(read.sources, record.sources);
    }
}

TEST_F(FilmFile, LayersOfLightReadBackAndHavePartsOfTheirOwn) {
    const FilmRecord record = randomRecord(*parseAovs("depth"), 1, {3, {"key light", "fill"}});
    const fs::path path = write(record);
    const FilmRecord read = readFilm(path);
    EXPECT_EQ(read.film.layers, record.film.layers);
    EXPECT_EQ(read.film.layout.light(), record.film.layout.light());
    Imf::MultiPartInputFile file(path.c_str());
    std::string names;
    for (int part = 0; part < file.parts(); ++part) names += file.header(part).name() + " ";
    EXPECT_EQ(names, "Combined depth emission direct bounce1 light_key_light light_fill vkpt.film ");
    EXPECT_NE(file.header(5).channels().findChannel("light_key_light.R"), nullptr);
    EXPECT_NE(file.header(7).channels().findChannel("vkpt.film.length2.B2"), nullptr);
    EXPECT_NE(file.header(7).channels().findChannel("vkpt.film.group1.R0"), nullptr);
    Film other(kWidth, kHeight, *parseAovs("depth"), {3, {"key light"}});
    EXPECT_THROW(addFilm(other, record.film), Error);
}

TEST_F(FilmFile, RefusesLayersOfLightThatCannotBe) {
    const std::pair<Json, const char*> cases[] = {
        {{{"perBounce", 17}}, "more layers of light"},
        {{{"perBounce", -1}}, ""},
        {{{"perBounce", "all"}}, "perBounce"},
        {{{"perBounce", 1}}, "vkpt.film.length0"},
        {{{"lightGroups", Json::array({1})}}, "lightGroups"},
        {{{"lightGroups", std::vector<std::string>(65, "x")}}, "more layers of light"},
    };
    for (const auto& [settings, reason] : cases) {
        FilmRecord record = randomRecord({});
        record.settings.update(settings);
        expectRefused(write(record), reason);
    }
}

TEST_F(FilmFile, PartsAndChannelsAreNamedAsBlenderAndNukeReadThem) {
    const fs::path path = write(randomRecord(kAllAovs));
    Imf::MultiPartInputFile file(path.c_str());
    ASSERT_EQ(file.parts(), static_cast<int>(kAovs.size()) + 2);
    const auto channels = [&](int part) {
        std::string names;
        const Imf::ChannelList& list = file.header(part).channels();
        for (auto c = list.begin(); c != list.end(); ++c)
            names += std::string(names.empty() ? "" : " ") + c.name() + (c.channel().type == Imf::UINT ? ":uint" : "");
        return file.header(part).name() + ": " + names;
    };
    EXPECT_EQ(channels(0), "Combined: A B G R");
    EXPECT_EQ(channels(1), "albedo: albedo.B albedo.G albedo.R");
    EXPECT_EQ(channels(2), "normal: normal.X normal.Y normal.Z");
    EXPECT_EQ(channels(3), "depth: depth.Z");
    EXPECT_EQ(channels(4), "position: position.X position.Y position.Z");
    EXPECT_EQ(channels(5), "uv: uv.A uv.U uv.V");
    EXPECT_EQ(channels(6), "primitive: primitive.X:uint");
    EXPECT_EQ(channels(9), "alpha: alpha.A");
    EXPECT_EQ(channels(10), "samples: samples.X:uint");
    EXPECT_EQ(channels(11), "variance: variance.Y");
    EXPECT_EQ(file.header(12).name(), "vkpt.film");
    for (int part = 0; part < file.parts(); ++part) {  // Nuke wants the same of all parts
        EXPECT_EQ(file.header(part).dataWindow(), file.header(0).dataWindow());
        EXPECT_EQ(file.header(part).lineOrder(), Imf::INCREASING_Y);
    }
}

TEST_F(FilmFile, APictureAloneIsAPlainFile) {
    const fs::path path = write(randomRecord({}), false);
    Imf::MultiPartInputFile file(path.c_str());
    EXPECT_EQ(file.parts(), 1);
    EXPECT_FALSE(file.header(0).hasName());
    expectRefused(path, "holds no film");
}

TEST_F(FilmFile, ThePictureIsWhatEveryReaderFinds) {
    const FilmRecord record = randomRecord(kAllAovs);
    EXPECT_EQ(readImage(write(record)).pixels, filmToImage(record.film).pixels);
}

// Another program, which knows README's description alone.
TEST_F(FilmFile, AStrangerReadsTheSums) {
    const FilmRecord record = randomRecord(*parseAovs("position"));
    const fs::path path = write(record);
    Imf::MultiPartInputFile file(path.c_str());
    const int last = file.parts() - 1;
    const auto read = [&](const std::string& channel) {
        std::vector<std::uint32_t> values(std::size_t{kWidth} * kHeight);
        Imf::FrameBuffer frame;
        frame.insert(channel, Imf::Slice(Imf::UINT, reinterpret_cast<char*>(values.data()), 4, 4 * kWidth));
        Imf::InputPart part(file, last);
        part.setFrameBuffer(frame);
        part.readPixels(0, kHeight - 1);
        return values;
    };
    const double samples = 44;  // 0:32,48:60
    EXPECT_EQ(file.header(last).typedAttribute<Imf::StringAttribute>("vkpt:samples").value(), "0:32,48:60");
    const auto g0 = read("vkpt.film.beauty.G0"), g1 = read("vkpt.film.beauty.G1"), g2 = read("vkpt.film.beauty.G2");
    const auto y0 = read("vkpt.film.position.Y0"), y1 = read("vkpt.film.position.Y1"),
               y2 = read("vkpt.film.position.Y2");
    const auto surface = read("vkpt.film.beauty.surface");
    const Image image = filmToImage(record.film), position = layerImages(record.film).front().image;
    for (std::uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const double green = std::ldexp(g2[i], 16) + std::ldexp(g1[i], -16) + std::ldexp(g0[i], -48);
        EXPECT_FLOAT_EQ(image.pixels[4 * i + 1], static_cast<float>(green / samples));
        const double y = std::ldexp(y2[i], 16) + std::ldexp(y1[i], -16) + std::ldexp(y0[i], -48);
        EXPECT_FLOAT_EQ(position.pixels[3 * i + 1], static_cast<float>(y / surface[i]));
    }
}

TEST_F(FilmFile, RefusesWhatIsNoFilm) {
    expectRefused(folder_ / "absent.exr", "cannot be opened");
    expectRefused(folder_.path(), "is a folder");
    expectRefused(folder_.write("text.exr", "hello"), "OpenEXR");
}

TEST_F(FilmFile, RefusesAttributesThatAreMissingOrWrong) {
    const FilmRecord record = randomRecord({});
    const auto with = [&](const std::string& key, const std::string& value) {
        ExrPart part = filmPart(record, {});
        for (auto& [name, text] : part.metadata)
            if (name == key) text = value;
        return part;
    };
    const auto without = [&](const std::string& key) {
        ExrPart part = filmPart(record, {});
        std::erase_if(part.metadata, [&](const auto& pair) { return pair.first == key; });
        return part;
    };
    for (const auto& [key, value] : filmPart(record, {}).metadata) expectRefused(writePart(without(key)), key.c_str());
    expectRefused(writePart(with("vkpt:film", "2")), "version 2");
    expectRefused(writePart(with("vkpt:samples", "0:99")), "beyond its 64");
    expectRefused(writePart(with("vkpt:samples", "0:32")), "do not hold its samples");
    expectRefused(writePart(with("vkpt:samples", "5:2")), "no ranges");
    expectRefused(writePart(with("vkpt:settings", "{\"seed\":4}")), "settings of its film are damaged");
    expectRefused(writePart(with("vkpt:settings", "{")), "no JSON");
    expectRefused(writePart(with("vkpt:sources", "[]")), "do not hold its samples");
    expectRefused(writePart(with("vkpt:sources", "{\"a\":1}")), "lack samples");
    expectRefused(writePart(with("vkpt:refused", "-1")), "vkpt:refused");
    expectRefused(writePart(with("vkpt:checksum", "0")), "checksum");
}

TEST_F(FilmFile, RefusesChannelsThatAreMissingOrOfAnotherType) {
    const FilmRecord record = randomRecord({});
    ExrPart part = filmPart(record, {});
    part.channels.pop_back();
    expectRefused(writePart(part), "lacks the channel vkpt.film.beauty.B2");
    part = filmPart(record, {});
    part.channels.front().type = ExrChannel::Type::Float;
    expectRefused(writePart(part), "lacks the channel vkpt.film.beauty.R0");
}

TEST_F(FilmFile, RefusesASizeOfAnotherRender) {
    FilmRecord record = randomRecord({});
    record.settings["size"] = "5x4";
    expectRefused(write(record), "size");
    record = randomRecord({});
    record.settings["aov"] = "motion";
    expectRefused(write(record), "no layers");
}

// Every length and every flipped byte: a FileError or the same film, never anything else.
TEST_F(FilmFile, SurvivesDamage) {
    const FilmRecord record = randomRecord(*parseAovs("depth,primitive"));
    const std::string whole = readText(write(record));
    std::size_t refused = 0, tried = 0;
    const auto attempt = [&](const std::string& bytes) {
        ++tried;
        try {
            const FilmRecord read = readFilm(folder_.write("damaged.exr", bytes));
            EXPECT_EQ(filmChecksum(read.film), filmChecksum(record.film));
            EXPECT_EQ(settingsHash(read.settings), settingsHash(record.settings));
        } catch (const FileError&) {
            ++refused;
        }
    };
    for (std::size_t length = 0; length < whole.size(); length += 29) attempt(whole.substr(0, length));
    std::mt19937 generator(5);
    for (std::size_t at = 0; at < whole.size(); at += 11) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << generator() % 8));
        attempt(bytes);
    }
    EXPECT_GT(refused, tried / 4) << "hardly any damage was noticed";
}

}  // namespace
}  // namespace vkpt
