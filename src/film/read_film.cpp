#include "film/read_film.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.h"
#include "base/exr_header.h"
#include "base/exr_input.h"
#include "base/file_bytes.h"
#include "film/film_part.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;
namespace attribute = film_attribute;

constexpr std::int64_t kMostSide = 65535;
constexpr std::uint32_t kBandPixels = 1U << 18U;

class Reader {
public:
    Reader(std::string name, std::span<const std::uint8_t> bytes)
        : name_(std::move(name)), input_(name_, bytes), file_(input_) {
        part_ = findPart();
    }

    FilmRecord read() {
        if (text(attribute::kVersion) != kFilmPartVersion)
            fail(fmt::format("its film is of version {}, this vkpt reads version {}", text(attribute::kVersion),
                             kFilmPartVersion));
        FilmRecord record;
        record.settings = parse(attribute::kSettings);
        if (!record.settings.is_object() || settingsHash(record.settings) != text(attribute::kSettingsHash))
            fail("the settings of its film are damaged");
        record.film = readSums(setting<std::string>(record.settings, "aov"), lightLayers(record.settings));
        readStory(record);
        return record;
    }

private:
    [[noreturn]] void fail(const std::string& fault) const { throw FileError(name_, fault); }

    [[nodiscard]] int findPart() const {
        for (int i = 0; i < file_.parts(); ++i)
            if (file_.header(i).hasName() && file_.header(i).name() == kFilmPartName) return i;
        fail("holds no film (part vkpt.film): written with --no-film, or not by vkpt");
    }

    [[nodiscard]] const Imf::Header& header() const { return file_.header(part_); }

    [[nodiscard]] const std::string& text(const char* key) const {
        const auto* found = header().findTypedAttribute<Imf::StringAttribute>(key);
        if (found == nullptr) fail(fmt::format("its film lacks the attribute {}", key));
        return found->value();
    }

    [[nodiscard]] Json parse(const char* key) const {
        Json json = Json::parse(text(key), nullptr, false);
        if (json.is_discarded()) fail(fmt::format("the attribute {} of its film is no JSON", key));
        return json;
    }

    template <class Value>
    [[nodiscard]] Value setting(const Json& object, const char* key) const {
        try {
            return object.at(key).get<Value>();
        } catch (const Json::exception&) {
            fail(fmt::format("the settings of its film lack {}", key));
        }
    }

    [[nodiscard]] SampleRanges ranges(const std::string& value) const {
        const auto parsed = parseSampleRanges(value);
        if (!parsed) fail(fmt::format("'{}' are no ranges of samples", value));
        return *parsed;
    }

    [[nodiscard]] std::uint64_t count(const char* key) const {
        const std::string& value = text(key);
        std::uint64_t number = 0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
        if (error != std::errc{} || end != value.data() + value.size()) fail(fmt::format("{} is no count", key));
        return number;
    }

    [[nodiscard]] glm::uvec2 size() const {
        const Imath::Box2i& window = header().dataWindow();
        const std::int64_t width = std::int64_t{window.max.x} + 1, height = std::int64_t{window.max.y} + 1;
        if (window.min != Imath::V2i(0, 0) || width <= 0 || height <= 0 || width > kMostSide || height > kMostSide)
            fail("the size of its film is not possible");
        return {width, height};
    }

    /// None in films of before there were any.
    [[nodiscard]] LightLayers lightLayers(const Json& settings) const {
        LightLayers light;
        if (settings.contains("perBounce")) light.lengths = setting<std::uint32_t>(settings, "perBounce");
        if (settings.contains("lightGroups")) light.groups = setting<std::vector<std::string>>(settings, "lightGroups");
        if (light.lengths > kMostLengthLayers || light.groups.size() > kMostLightGroups)
            fail("its film has more layers of light than there can be");
        return light;
    }

    /// Where the library is to put the rows from `y` on.
    [[nodiscard]] Imf::FrameBuffer frameBuffer(const Film& band, std::uint32_t y) const {
        Imf::FrameBuffer frame;
        for (const FilmChannel& channel : filmChannels(band)) {
            const Imf::Channel* stored = header().channels().findChannel(channel.name);
            if (stored == nullptr || stored->type != Imf::UINT || stored->xSampling != 1 || stored->ySampling != 1)
                fail(fmt::format("its film lacks the channel {}, or it is not whole", channel.name));
            const std::size_t rowStride = channel.pixelStride * band.width;
            char* first = reinterpret_cast<char*>(const_cast<std::uint32_t*>(channel.first));
            frame.insert(channel.name, Imf::Slice(Imf::UINT, first - y * rowStride, channel.pixelStride, rowStride));
        }
        return frame;
    }

    /// The integers, a band of rows after the other: memory grows only as the file proves to hold them. Channels that
    /// this version does not know are passed over.
    [[nodiscard]] Film readSums(const std::string& aovNames, const LightLayers& light) {
        const auto aovs = parseAovs(aovNames);
        if (!aovs) fail(fmt::format("'{}' are no layers that this vkpt knows", aovNames));
        if (header().type() != Imf::SCANLINEIMAGE) fail("its film is not stored in scan lines");
        Film film(0, 0, *aovs, light);
        const glm::uvec2 frame = size();
        film.width = frame.x;
        film.height = frame.y;
        Imf::InputPart part(file_, part_);
        const std::uint32_t bandRows = std::max(kBandPixels / frame.x, 1U);
        for (std::uint32_t y = 0; y < frame.y; y += bandRows) {
            Film band(frame.x, std::min(bandRows, frame.y - y), *aovs, light);
            part.setFrameBuffer(frameBuffer(band, y));
            part.readPixels(static_cast<int>(y), static_cast<int>(y + band.height - 1));
            film.sums.insert(film.sums.end(), band.sums.begin(), band.sums.end());
            film.layers.insert(film.layers.end(), band.layers.begin(), band.layers.end());
        }
        if (filmChecksum(film) != text(attribute::kChecksum)) fail("its film is damaged: the checksum is another");
        return film;
    }

    void readStory(FilmRecord& record) const {
        Film& film = record.film;
        film.ranges = ranges(text(attribute::kSamples));
        film.refused = count(attribute::kRefused);
        film.refusedInLayers = count(attribute::kRefusedInLayers);
        const auto spp = setting<std::uint32_t>(record.settings, "spp");
        if (film.sampleEnd() > spp) fail(fmt::format("its film holds samples beyond its {}", spp));
        if (setting<std::string>(record.settings, "size") != fmt::format("{}x{}", film.width, film.height))
            fail("its film is not of the size that its settings state");
        SampleRanges together;
        for (const Json& source : parse(attribute::kSources)) {
            FilmSource s{ranges(setting<std::string>(source, "samples")), setting<std::string>(source, "backend"),
                         setting<std::string>(source, "device"), setting<std::string>(source, "driver")};
            if (overlapOf(together, s.samples)) fail("two sources of its film hold the same samples");
            together = unite(together, s.samples);
            record.sources.push_back(std::move(s));
        }
        if (together != film.ranges) fail("the sources of its film do not hold its samples");
    }

    std::string name_;
    ExrInput input_;
    Imf::MultiPartInputFile file_;
    int part_ = 0;
};

}  // namespace

FilmRecord readFilm(const fs::path& path) {
    const std::string name = path.string();
    const std::vector<std::uint8_t> bytes = readFileBytes(path);
    try {
        checkExrHeaders(name, bytes);
        return Reader(name, bytes).read();
    } catch (const Iex::BaseExc& fault) {
        throw FileError(name, fmt::format("OpenEXR: {}", fault.what()));
    }
}

}  // namespace vkpt
