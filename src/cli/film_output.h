// The files of render and merge: options, checks beforehand, writing.
#pragma once
#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "film/film_record.h"
#include "film/write_image.h"

namespace vkpt {

struct OutputOptions {
    std::vector<std::filesystem::path> files;
    WriteOptions write;
    std::optional<ToneMap> toneMap;  ///< of PNG files; else neutral for light and none for what is no light
    bool film = true;                ///< EXR files hold the exact film
};

/// `-o`, how PNG files look, and --no-film. `whenAbsent`: what the help says of no -o.
void addOutputOptions(CLI::App& app, OutputOptions& options, const std::string& whenAbsent);

/// Finds out what cannot be written before an hour of work, not after. Throws Error (usage) for an extension that is
/// no format, FileError for a file that cannot be written.
void checkOutputs(const OutputOptions& options);

/// Where the contact sheet of layers of light goes: beside the first file, "a.exr" and "bounces" make "a_bounces.png".
[[nodiscard]] std::filesystem::path contactSheetFile(const OutputOptions& options, const char* what);
/// Before the work: it can be written, and takes no other output's place. Throws Error (usage), FileError.
void checkContactSheet(const OutputOptions& options, const char* what);
inline constexpr const char *kBounceSheet = "bounces", *kLightSheet = "lights";

/// Writes every file, and a contact sheet of each kind of layers of light that the film has. Each appears whole or not
/// at all. Throws FileError.
void writeFilmFiles(const FilmRecord& record, const OutputOptions& options);

/// Writes an EXR file with everything in it. Throws FileError.
void writeFilm(const std::filesystem::path& file, const FilmRecord& record);

/// Tells of what was refused, and of samples from several devices.
void warnOfFilm(const FilmRecord& record);

}  // namespace vkpt
