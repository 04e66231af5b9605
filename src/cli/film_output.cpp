#include "cli/film_output.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "cli/metadata.h"
#include "cli/options.h"
#include "compare/heat_map.h"
#include "film/contact_sheet.h"
#include "film/encode_film.h"

namespace vkpt {

void addOutputOptions(CLI::App& app, OutputOptions& options, const std::string& whenAbsent) {
    const char* group = "Output";
    app.add_option("-o,--output", options.files,
                   fmt::format("picture to write: {}; may be repeated{}", kImageExtensions, whenAbsent))
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->group(group);
    app.add_flag_callback(
           "--no-film", [&options] { options.film = false; },
           "leave the exact film out of EXR files: smaller, but nothing to merge or resume")
        ->group(group);
    addParsed(app, "--exposure", options.write.display.exposure, parseNumber<float>, "EV",
              "of PNG files: 1 EV doubles the light (default: 0)", kReal)
        ->group(group);
    addParsed(app, "--tonemap", options.toneMap, nameIn(kToneMaps), namesOf(kToneMaps),
              "of PNG files (default: neutral; none where --integrator is not path or direct)")
        ->group(group);
    addParsed(
        app, "--bits", options.write.pngBits,
        [](std::string_view text) {
            return text == "8" ? std::optional(8) : text == "16" ? std::optional(16) : std::nullopt;
        },
        "8|16", "of PNG files, a channel (default: 8)")
        ->group(group);
}

void checkOutputs(const OutputOptions& options) {
    for (const auto& file : options.files) {
        if (!imageFormat(file))
            throw usageError("--output",
                             fmt::format("'{}' does not end in one of {}", file.string(), kImageExtensions));
        checkWritable(file);
    }
}

std::filesystem::path contactSheetFile(const OutputOptions& options, const char* what) {
    std::filesystem::path file = options.files.front();
    return file.replace_filename(fmt::format("{}_{}.png", file.stem().string(), what));
}

void checkContactSheet(const OutputOptions& options, const char* what) {
    const std::filesystem::path sheet = contactSheetFile(options, what);
    if (std::ranges::find(options.files, sheet) != options.files.end())
        throw usageError("--output", fmt::format("'{}' is what the contact sheet is called", sheet.string()));
    checkWritable(sheet);
}

void writeFilm(const std::filesystem::path& file, const FilmRecord& record) {
    writeFileAtomically(file, encodeFilm(filmImages(record.film), record, true, imageMetadata(record)));
}

void warnOfFilm(const FilmRecord& record) {
    const Film& film = record.film;
    if (film.refused > 0)
        spdlog::warn("{} contributions were NaN, infinite or out of range and do not count", film.refused);
    if (film.refusedInLayers > 0)
        spdlog::warn("{} values of layers were NaN, infinite or out of range and do not count", film.refusedInLayers);
    if (const std::uint64_t paths = pathsWithoutVariance(film); paths > 0)
        spdlog::warn("{} paths of 2^32 nits or more do not count in the variance", paths);
    if (record.sources.size() > 1)
        spdlog::info("the samples are of {} devices, which agree up to rounding only: {}", record.sources.size(),
                     devicesOf(record));
}

namespace {

/// The PNG of a look whose values are no colours: false colours over a scale. Of cost the sum of red and green.
Bytes encodeFalseColors(const Image& beauty, bool isCost, const ImageMetadata& metadata) {
    Image values(beauty.width, beauty.height, 1);
    for (std::size_t i = 0; i < values.pixels.size(); ++i)
        values.pixels[i] = std::max(0.0F, beauty.pixels[4 * i] + (isCost ? beauty.pixels[4 * i + 1] : 0));
    const char* title = isCost ? "nodes + triangles tested a ray" : "depth, metres";
    return encodePng(heatMap(values, {title}), 8, metadata);
}

void writeSheet(const std::filesystem::path& file, const std::vector<LightImage>& layers, const Image& beauty,
                const WriteOptions& write, const ImageMetadata& metadata) {
    if (layers.empty()) return;
    writeFileAtomically(file, encodePng(contactSheet(layers, beauty, write.display), 8, metadata));
    spdlog::info("wrote {}", file.string());
}

}  // namespace

void writeFilmFiles(const FilmRecord& record, const OutputOptions& options) {
    const FilmImages images = filmImages(record.film);
    const ImageMetadata metadata = imageMetadata(record);
    WriteOptions write = options.write;
    const std::string integrator = record.settings.value("integrator", "path");
    const bool isCost = integrator == "cost", isDepth = integrator == "depth";
    const bool isLight = integrator == "path" || integrator == "direct";
    write.display.toneMap = options.toneMap.value_or(isLight ? ToneMap::Neutral : ToneMap::None);
    write.display.transparent = record.settings.value("background", "") == "transparent";
    for (const auto& file : options.files) {
        if (imageFormat(file) == ImageFormat::Exr)
            writeFileAtomically(file, encodeFilm(images, record, options.film, metadata));
        else if ((isCost || isDepth) && imageFormat(file) == ImageFormat::Png)
            writeFileAtomically(file, encodeFalseColors(images.beauty, isCost, metadata));
        else
            writeImage(file, images.beauty, write, metadata);
        spdlog::info("wrote {}", file.string());
    }
    writeSheet(contactSheetFile(options, kBounceSheet), images.lengths, images.beauty, write, metadata);
    writeSheet(contactSheetFile(options, kLightSheet), images.groups, images.beauty, write, metadata);
}

}  // namespace vkpt
