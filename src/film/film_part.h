// The exact film as a part of an EXR file: its integers in UINT channels, what they are of in string attributes.
// README, "The film format".
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "film/encode.h"
#include "film/film_record.h"

namespace vkpt {

inline constexpr std::string_view kFilmPartName = "vkpt.film";
inline constexpr std::string_view kFilmPartVersion = "1";

/// Attributes of the part.
namespace film_attribute {
inline constexpr const char* kVersion = "vkpt:film";
inline constexpr const char* kSamples = "vkpt:samples";
inline constexpr const char* kSettings = "vkpt:settings";
inline constexpr const char* kSettingsHash = "vkpt:settingsHash";
inline constexpr const char* kSources = "vkpt:sources";
inline constexpr const char* kRefused = "vkpt:refused";
inline constexpr const char* kRefusedInLayers = "vkpt:refusedInLayers";
inline constexpr const char* kChecksum = "vkpt:checksum";
}  // namespace film_attribute

/// One channel of the part, and where its integers lie in a film.
struct FilmChannel {
    std::string name;            ///< "vkpt.film.BLOCK.CHANNEL"
    const std::uint32_t* first;  ///< of the upper left pixel
    std::size_t pixelStride;     ///< bytes
};

/// All channels of a film, every word of it but those that are always 0.
[[nodiscard]] std::vector<FilmChannel> filmChannels(const Film& film);

/// 32 hexadecimal digits, of all integers of the film.
[[nodiscard]] std::string filmChecksum(const Film& film);

/// The part of a record, which must outlive its encoding. `metadata` comes before the part's own attributes.
[[nodiscard]] ExrPart filmPart(const FilmRecord& record, ImageMetadata metadata);

}  // namespace vkpt
