// A film with its story: what was rendered and by what. Enough to tell which films belong together.
#pragma once
#include <string>
#include <vector>

#include "base/json.h"
#include "film/film.h"

namespace vkpt {

/// Who computed some of the samples.
struct FilmSource {
    SampleRanges samples;
    std::string backend, device, driver;

    friend bool operator==(const FilmSource&, const FilmSource&) = default;
};

/// All that the part vkpt.film of a file holds.
struct FilmRecord {
    Film film;
    /// Names and values, most telling first. Equal but for isDescription keys: samples of one and the same render.
    /// "spp", "size" and "aov" are always there; "perBounce" and "lightGroups" say which layers of light there are.
    Json settings;
    std::vector<FilmSource> sources;  ///< ascending; together they hold the samples of the film
};

/// A setting that only helps to read the others, such as the name of a file: what it stands for is compared elsewhere.
[[nodiscard]] bool isDescription(const std::string& key);

/// 32 hexadecimal digits, of the settings but the descriptions.
[[nodiscard]] std::string settingsHash(const Json& settings);

/// "seed is 1 here and 0 there": the first setting that keeps the films apart; empty where none does.
[[nodiscard]] std::string differenceOf(const Json& here, const Json& there);

/// "cpu" or "cpu, vulkan": what the sources have in common or not, each once, sorted.
[[nodiscard]] std::string backendsOf(const FilmRecord& record);
[[nodiscard]] std::string devicesOf(const FilmRecord& record);

/// Adds `other`, of the same settings. The result does not depend on which is added to which. Throws what addFilm
/// throws.
void addRecord(FilmRecord& into, const FilmRecord& other);

/// Adds samples that one device has computed. Throws what addFilm throws.
void addSamples(FilmRecord& into, const Film& film, const std::string& backend, const std::string& device,
                const std::string& driver);

}  // namespace vkpt
