#include "cli/parse.h"

#include <algorithm>

#include "scene/pixel_filter.h"

namespace vkpt {
namespace {

struct Halves {
    std::string_view left, right;
};

std::optional<Halves> splitAt(std::string_view text, char separator) {
    const std::size_t at = text.find(separator);
    if (at == std::string_view::npos) return std::nullopt;
    return Halves{text.substr(0, at), text.substr(at + 1)};
}

std::optional<glm::uvec2> parsePair(std::string_view text, char separator) {
    const auto halves = splitAt(text, separator);
    if (!halves) return std::nullopt;
    const auto a = parseNumber<std::uint32_t>(halves->left), b = parseNumber<std::uint32_t>(halves->right);
    if (!a || !b) return std::nullopt;
    return glm::uvec2(*a, *b);
}

}  // namespace

std::optional<glm::uvec2> parseSize(std::string_view text) {
    const auto size = parsePair(text, 'x');
    if (!size || size->x == 0 || size->y == 0 || size->x > 65535 || size->y > 65535) return std::nullopt;
    return size;
}

std::optional<glm::uvec2> parsePixel(std::string_view text) { return parsePair(text, ','); }

std::optional<SampleRange> parseSampleRange(std::string_view text) {
    const auto range = parsePair(text, ':');
    if (!range || range->x >= range->y) return std::nullopt;
    return SampleRange{range->x, range->y};
}

std::optional<bool> parseSwitch(std::string_view text) {
    if (text == "on") return true;
    if (text == "off") return false;
    return std::nullopt;
}

std::optional<glm::vec3> parseVec3(std::string_view text) {
    const auto first = splitAt(text, ',');
    const auto second = first ? splitAt(first->right, ',') : std::nullopt;
    if (!second) return std::nullopt;
    const auto x = parseNumber<float>(first->left), y = parseNumber<float>(second->left),
               z = parseNumber<float>(second->right);
    if (!x || !y || !z) return std::nullopt;
    return glm::vec3(*x, *y, *z);
}

std::optional<glm::vec3> parseColor(std::string_view text) {
    const auto color = parseVec3(text);
    return color && color->x >= 0 && color->y >= 0 && color->z >= 0 ? color : std::nullopt;
}

std::optional<glm::vec3> parseOrbit(std::string_view text) {
    const auto orbit = parseVec3(text);
    return orbit && orbit->z > 0 ? orbit : std::nullopt;
}

std::optional<Roulette> parseRoulette(std::string_view text) {
    if (text == "off") return Roulette{kRouletteOff, 1};
    if (text == "throughput") return Roulette{kRouletteThroughput, 1};
    const auto halves = splitAt(text, ':');
    if (!halves || halves->left != "fixed") return std::nullopt;
    const auto survival = numberWithin(kLeastSurvival, 1.0F)(halves->right);
    if (!survival) return std::nullopt;
    return Roulette{kRouletteFixed, *survival};
}

std::optional<PixelFilter> parseFilter(std::string_view text) {
    constexpr float kMost = 16;
    const std::string_view name = text.substr(0, text.find(':'));
    const auto* info = std::ranges::find(kFilters, name, &FilterInfo::name);
    if (info == kFilters.end()) return std::nullopt;
    if (name == text) return PixelFilter{info->id, info->radius};
    const auto radius = parseNumber<float>(text.substr(name.size() + 1));
    if (!radius || *radius <= 0 || *radius > kMost) return std::nullopt;
    return PixelFilter{info->id, *radius};
}

std::optional<LightGroupChoice> parseLightGroups(std::string_view text) {
    if (text == "none") return LightGroupChoice{};
    LightGroupChoice choice{true, {}};
    if (text == "all") return choice;
    for (;;) {
        const std::size_t comma = text.find(',');
        if (comma == 0 || text.empty()) return std::nullopt;
        choice.names.emplace_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return choice;
        text.remove_prefix(comma + 1);
    }
}

std::optional<Background> parseBackground(std::string_view text) {
    if (text == "env") return Background{kBackgroundEnvironment, {}};
    if (text == "transparent") return Background{kBackgroundTransparent, {}};
    const auto color = parseColor(text);
    if (!color) return std::nullopt;
    return Background{kBackgroundColor, *color};
}

std::optional<EnvironmentChoice> parseEnvironment(std::string_view text) {
    using Kind = EnvironmentChoice::Kind;
    if (text.empty()) return std::nullopt;
    if (text == "none") return EnvironmentChoice{Kind::None, {}, {}};
    if (text == "studio") return EnvironmentChoice{Kind::Studio, {}, {}};
    if (const auto color = parseColor(text)) return EnvironmentChoice{Kind::Color, *color, {}};
    if (parseVec3(text)) return std::nullopt;  // a colour below 0, no file
    return EnvironmentChoice{Kind::File, {}, std::filesystem::path(text)};
}

}  // namespace vkpt
