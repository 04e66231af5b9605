// vkpt merge: the samples of several renders of one picture, added up exactly.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/film_output.h"
#include "cli/options.h"
#include "film/read_film.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

struct MergeCommand {
    std::vector<fs::path> files;
    OutputOptions output;
    bool allowHoles = false;
    Verbosity verbosity = Verbosity::Normal;
};

/// A file that was added, and what it brought.
struct Added {
    fs::path file;
    SampleRanges ranges;
};

[[noreturn]] void refuse(const fs::path& file, const fs::path& other, const std::string& reason) {
    throw FileError(file.string(), fmt::format("cannot be merged with {}: {}", other.string(), reason));
}

/// Throws FileError, naming both files and the reason, where `record` does not belong to what was added before.
void checkFits(const FilmRecord& merged, const std::vector<Added>& added, const fs::path& file,
               const FilmRecord& record) {
    if (const std::string difference = differenceOf(record.settings, merged.settings); !difference.empty())
        refuse(file, added.front().file, difference);
    for (const Added& earlier : added)
        if (const auto both = overlapOf(earlier.ranges, record.film.ranges))
            refuse(file, earlier.file, fmt::format("both hold samples {}:{}", both->begin, both->end));
}

/// The file that holds sample `index`.
const fs::path& holderOf(const std::vector<Added>& added, std::uint32_t index) {
    return std::ranges::find_if(added,
                                [&](const Added& a) {
                                    return overlapOf(a.ranges, {{index, index + 1}}).has_value();
                                })
        ->file;
}

void checkHoles(const std::vector<Added>& added, const SampleRanges& ranges) {
    if (ranges.size() < 2) return;
    const std::uint32_t begin = ranges[0].end, end = ranges[1].begin;
    refuse(holderOf(added, end), holderOf(added, begin - 1),
           fmt::format("no file holds samples {}:{} between them (see --allow-holes)", begin, end));
}

FilmRecord mergeFiles(const MergeCommand& c) {
    FilmRecord merged;
    std::vector<Added> added;
    for (const fs::path& file : c.files) {
        FilmRecord record = readFilm(file);
        spdlog::debug("{} holds samples {}", file.string(), rangesText(record.film.ranges));
        if (!added.empty()) checkFits(merged, added, file, record);
        added.push_back({file, record.film.ranges});
        if (added.size() == 1)
            merged = std::move(record);
        else
            addRecord(merged, record);
    }
    if (!c.allowHoles) checkHoles(added, merged.film.ranges);
    return merged;
}

ExitCode runMerge(MergeCommand& c) {
    setUpLog(c.verbosity);
    checkOutputs(c.output);
    const FilmRecord merged = mergeFiles(c);
    spdlog::info("samples {} of {}, out of {} files", rangesText(merged.film.ranges),
                 merged.settings.at("spp").get<std::uint32_t>(), c.files.size());
    warnOfFilm(merged);
    const LightLayers& light = merged.film.layout.light();
    if (light.lengths > 0) checkContactSheet(c.output, kBounceSheet);
    if (!light.groups.empty()) checkContactSheet(c.output, kLightSheet);
    writeFilmFiles(merged, c.output);
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpMerge(CLI::App& app) {
    const auto command = std::make_shared<MergeCommand>();
    app.add_option("FILES", command->files, "EXR files that vkpt render or merge wrote, in any order")
        ->required()
        ->type_name("FILE.exr ...");
    addOutputOptions(app, command->output, "");
    app.get_option("--output")->required();
    app.add_flag("--allow-holes", command->allowHoles, "merge although samples between those of the files are missing");
    addVerbosity(app, command->verbosity);
    return [command] { return runMerge(*command); };
}

}  // namespace

const Command kMergeCommand{"merge", "add up ranges of samples that were rendered apart",
                            "vkpt merge a.exr b.exr c.exr -o whole.exr -o whole.png", setUpMerge};

}  // namespace vkpt
