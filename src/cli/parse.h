// Texts of the command line to values. Every function is empty-handed on a malformed text.
#pragma once
#include <charconv>
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string_view>

#include "constants.h"
#include "scene/light_groups.h"
#include "scene/sample_ranges.h"

namespace vkpt {

/// Decimal; the whole text must be the number, and a float finite.
template <class T>
[[nodiscard]] std::optional<T> parseNumber(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    if constexpr (std::is_floating_point_v<T>)
        if (!std::isfinite(value)) return std::nullopt;
    return value;
}

/// A number from `least` to `most`, both allowed.
template <class T>
[[nodiscard]] auto numberWithin(T least, T most = std::numeric_limits<T>::max()) {
    return [least, most](std::string_view text) {
        const std::optional<T> value = parseNumber<T>(text);
        return value && *value >= least && *value <= most ? value : std::nullopt;
    };
}

/// "960x540": both 1 to 65535, as a sample id packs a pixel's coordinates into 16 bits each.
[[nodiscard]] std::optional<glm::uvec2> parseSize(std::string_view text);

/// "X,Y": a pixel, column and row from the upper left corner.
[[nodiscard]] std::optional<glm::uvec2> parsePixel(std::string_view text);

/// "64:128": begin < end.
[[nodiscard]] std::optional<SampleRange> parseSampleRange(std::string_view text);

/// "X,Y,Z": finite numbers.
[[nodiscard]] std::optional<glm::vec3> parseVec3(std::string_view text);

/// "on" or "off".
[[nodiscard]] std::optional<bool> parseSwitch(std::string_view text);

/// "R,G,B": finite and not negative.
[[nodiscard]] std::optional<glm::vec3> parseColor(std::string_view text);

/// "THETA,PHI,RADIUS": degrees about and from the vertical axis, metres above 0.
[[nodiscard]] std::optional<glm::vec3> parseOrbit(std::string_view text);

/// Of fixed:P. Random numbers have 24 bits, so that a path goes on with P rounded up to 2^-24: here that is 0.006 %
/// more light at most, of P = 1e-9 sixty times as much.
inline constexpr float kLeastSurvival = 1e-3F;

/// "off", "throughput" or "fixed:P" with kLeastSurvival <= P <= 1.
struct Roulette {
    std::uint32_t mode = kRouletteThroughput;
    float survival = 1;  ///< P of fixed:P
};
[[nodiscard]] std::optional<Roulette> parseRoulette(std::string_view text);

/// "NAME" or "NAME:RADIUS" of kFilters, 0 < RADIUS <= 16.
struct PixelFilter {
    std::uint32_t id = kFilterBox;
    float radius = 0.5F;
};
[[nodiscard]] std::optional<PixelFilter> parseFilter(std::string_view text);

/// "all", "none", or names with commas between them.
[[nodiscard]] std::optional<LightGroupChoice> parseLightGroups(std::string_view text);

/// "env", "transparent" or "R,G,B".
struct Background {
    std::uint32_t mode = kBackgroundEnvironment;
    glm::vec3 color{0};
};
[[nodiscard]] std::optional<Background> parseBackground(std::string_view text);

/// What lights the scene from afar. Automatic: the studio where the scene has no light of its own, else none.
struct EnvironmentChoice {
    enum class Kind { Automatic, None, Studio, Color, File } kind = Kind::Automatic;
    glm::vec3 color{0};
    std::filesystem::path file;
};
/// "studio", "none", "R,G,B", else a file; three numbers are never the name of one.
[[nodiscard]] std::optional<EnvironmentChoice> parseEnvironment(std::string_view text);

}  // namespace vkpt
