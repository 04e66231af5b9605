#include "film/film_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/hash.h"
#include "base/json.h"

namespace vkpt {
namespace {

constexpr std::array kDescriptions{"scene", "sceneIndex", "env", "envRotation", "envStrength"};
/// Values that are hashes, which nobody can read.
constexpr std::array kHashes{"geometry", "materials", "lights", "environment", "options"};

template <class Names>
bool contains(const Names& names, const std::string& key) {
    return std::ranges::find(names, key) != names.end();
}

std::string valueText(const Json& settings, const std::string& key) {
    const auto at = settings.find(key);
    if (at == settings.end()) return "absent";
    return at->is_string() ? at->get<std::string>() : at->dump();
}

std::string valuesDiffer(const Json& here, const Json& there, const std::string& key) {
    return fmt::format("{} is {} here and {} there", key, valueText(here, key), valueText(there, key));
}

/// Of a hash: a description that explains it, if there is one.
std::string hashesDiffer(const Json& here, const Json& there, const std::string& key) {
    std::string text = fmt::format("{} differ{}", key, key.ends_with('s') ? "" : "s");
    for (const char* description : kDescriptions)
        if (valueText(here, description) != valueText(there, description))
            return fmt::format("{} ({})", text, valuesDiffer(here, there, description));
    return text;
}

template <class Field>
std::string joined(const FilmRecord& record, Field field) {
    std::set<std::string> names;
    for (const FilmSource& source : record.sources) names.insert(source.*field);
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// One entry for each maker, ascending by their first sample.
void addSource(std::vector<FilmSource>& sources, const FilmSource& added) {
    const auto sameMaker = [&](const FilmSource& s) {
        return s.backend == added.backend && s.device == added.device && s.driver == added.driver;
    };
    const auto known = std::ranges::find_if(sources, sameMaker);
    if (known != sources.end())
        known->samples = unite(known->samples, added.samples);
    else
        sources.push_back(added);
    std::ranges::sort(sources, {}, [](const FilmSource& s) { return s.samples.empty() ? 0 : s.samples.front().begin; });
}

}  // namespace

bool isDescription(const std::string& key) { return contains(kDescriptions, key); }

std::string settingsHash(const Json& settings) {
    ContentHash hash;
    for (const auto& [key, value] : settings.items())
        if (!isDescription(key)) hash.add(key).add(jsonText(value, -1));
    return hash.hex();
}

std::string differenceOf(const Json& here, const Json& there) {
    for (const auto& [key, value] : here.items()) {
        if (isDescription(key) || valueText(here, key) == valueText(there, key)) continue;
        return contains(kHashes, key) ? hashesDiffer(here, there, key) : valuesDiffer(here, there, key);
    }
    for (const auto& [key, value] : there.items())
        if (!isDescription(key) && !here.contains(key)) return valuesDiffer(here, there, key);
    return {};
}

std::string backendsOf(const FilmRecord& record) { return joined(record, &FilmSource::backend); }
std::string devicesOf(const FilmRecord& record) { return joined(record, &FilmSource::device); }

void addRecord(FilmRecord& into, const FilmRecord& other) {
    if (!other.film.ranges.empty() && other.film.sampleBegin() < into.film.sampleBegin())
        into.settings = other.settings;  // of descriptions, those of the lowest sample
    addFilm(into.film, other.film);
    for (const FilmSource& source : other.sources) addSource(into.sources, source);
}

void addSamples(FilmRecord& into, const Film& film, const std::string& backend, const std::string& device,
                const std::string& driver) {
    addFilm(into.film, film);
    addSource(into.sources, {film.ranges, backend, device, driver});
}

}  // namespace vkpt
