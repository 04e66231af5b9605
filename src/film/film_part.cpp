#include "film/film_part.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "base/json.h"

namespace vkpt {
namespace {

void addChannels(std::vector<FilmChannel>& channels, const FilmBlock& block, const uvec4* words, std::size_t stride) {
    for (std::size_t w = 0; w < block.words.size(); ++w)
        for (int c = 0; c < 4; ++c) {
            const std::string& name = block.words[w].channels[static_cast<std::size_t>(c)];
            if (name.empty()) continue;
            channels.push_back({fmt::format("{}.{}.{}", kFilmPartName, block.name, name),
                                &words[block.firstWord + w][c], stride * sizeof(uvec4)});
        }
}

std::string sourcesText(const std::vector<FilmSource>& sources) {
    Json list = Json::array();
    for (const FilmSource& source : sources)
        list.push_back({{"samples", rangesText(source.samples)},
                        {"backend", source.backend},
                        {"device", source.device},
                        {"driver", source.driver}});
    return list.dump();
}

}  // namespace

std::vector<FilmChannel> filmChannels(const Film& film) {
    static_assert(sizeof(FilmSums) == 3 * sizeof(uvec4));
    std::vector<FilmChannel> channels;
    addChannels(channels, beautyBlock(), &film.sums.data()->red, 3);
    for (const FilmBlock& block : film.layout.blocks())
        addChannels(channels, block, film.layers.data(), film.layout.words());
    return channels;
}

std::string filmChecksum(const Film& film) { return ContentHash().add(film.sums).add(film.layers).hex(); }

ExrPart filmPart(const FilmRecord& record, ImageMetadata metadata) {
    namespace attribute = film_attribute;
    ExrPart part{std::string(kFilmPartName), std::move(metadata), {}};
    const auto put = [&](const char* key, std::string value) {
        for (auto& [known, old] : part.metadata)
            if (known == key) return void(old = std::move(value));
        part.metadata.emplace_back(key, std::move(value));
    };
    put(attribute::kVersion, std::string(kFilmPartVersion));
    put(attribute::kSamples, rangesText(record.film.ranges));
    put(attribute::kSettings, jsonText(record.settings, -1));
    put(attribute::kSettingsHash, settingsHash(record.settings));
    put(attribute::kSources, sourcesText(record.sources));
    put(attribute::kRefused, std::to_string(record.film.refused));
    put(attribute::kRefusedInLayers, std::to_string(record.film.refusedInLayers));
    put(attribute::kChecksum, filmChecksum(record.film));
    for (const FilmChannel& channel : filmChannels(record.film))
        part.channels.push_back({channel.name, ExrChannel::Type::Uint, channel.first, channel.pixelStride});
    return part;
}

}  // namespace vkpt
