// vkpt render: a scene to one or more picture files.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <memory>

#include "base/atomic_file.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/version.h"
#include "cli/backend.h"
#include "cli/clock.h"
#include "cli/command.h"
#include "cli/fill_film.h"
#include "cli/film_output.h"
#include "cli/metadata.h"
#include "cli/output_name.h"
#include "cli/scene_setup.h"
#include "cli/thread_limit.h"
#include "film/read_film.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

struct RenderCommand {
    SceneOptions scene;
    SamplingOptions sampling;
    BackendOptions backend;
    OutputOptions output;
    std::optional<double> timeLimit, checkpoint;  ///< seconds
    fs::path resume, stats;
    Verbosity verbosity = Verbosity::Normal;
};

bool isExr(const fs::path& file) { return imageFormat(file) == ImageFormat::Exr; }

void addRunOptions(CLI::App& app, RenderCommand& c) {
    const char* group = "Output";
    app.add_option("--resume", c.resume,
                   "go on from the samples that this file holds, where it is there, and write it like -o FILE.exr")
        ->type_name("FILE.exr")
        ->group(group);
    addParsed(app, "--checkpoint", c.checkpoint, numberWithin(0.0, 1e9), "S",
              "save the file of --resume, or the first .exr of -o, every S seconds", "a number, 0 or above")
        ->group(group);
    app.add_option("--stats", c.stats, "write times, rays and memory as JSON")->type_name("FILE")->group(group);
    addParsed(app, "--time-limit", c.timeLimit, numberWithin(std::numeric_limits<double>::min(), 1e9), "S",
              "stop rendering after S seconds, at the end of a pass", kPositive)
        ->group(group);
    addVerbosity(app, c.verbosity);
}

/// What files there will be; faults of the options that ask for them.
void settleOutputs(RenderCommand& c) {
    std::vector<fs::path>& files = c.output.files;
    if (!c.resume.empty()) {
        if (!isExr(c.resume)) throw usageError("--resume", fmt::format("'{}' is no .exr file", c.resume.string()));
        if (std::ranges::find(files, c.resume) == files.end()) files.push_back(c.resume);
    }
    if (files.empty()) files.push_back(defaultOutput(c.scene.file));
    const bool exr = std::ranges::any_of(files, isExr);
    if (!c.sampling.aovs.empty() && !exr) throw usageError("--aov", "needs an .exr file among the outputs");
    if (c.checkpoint && !exr) throw usageError("--checkpoint", "needs an .exr file among the outputs");
    if (!c.output.film && (c.checkpoint || !c.resume.empty()))
        throw usageError("--no-film", "leaves nothing that --checkpoint could save or --resume go on from");
    checkOutputs(c.output);
    if (c.sampling.perBounce) checkContactSheet(c.output, kBounceSheet);
    if (c.sampling.lightGroups.on) checkContactSheet(c.output, kLightSheet);
    if (!c.stats.empty()) checkWritable(c.stats);
}

/// The film to begin with: that of --resume, or an empty one.
FilmRecord startFilm(const RenderCommand& c, const PreparedScene& prepared) {
    const RenderParams& params = prepared.options.params;
    FilmRecord fresh{
        Film(params.width, params.height, prepared.options.aovs, prepared.options.light), renderSettings(prepared), {}};
    if (c.resume.empty()) return fresh;
    if (!fs::exists(c.resume)) {
        spdlog::info("{} is not there yet: starting afresh", c.resume.string());
        return fresh;
    }
    FilmRecord held = readFilm(c.resume);
    if (const std::string difference = differenceOf(fresh.settings, held.settings); !difference.empty())
        throw FileError(c.resume.string(), fmt::format("cannot be resumed: {}", difference));
    spdlog::info("{} holds samples {}", c.resume.string(), rangesText(held.film.ranges));
    return held;
}

struct Rendered {
    FilmRecord record;
    RenderReport report;
    std::uint32_t before = 0;  ///< samples a pixel that were there already
    double secondsToFirstPass = 0;
};

/// A save that fails is no reason to lose the render.
void saveCheckpoint(const RenderCommand& c, const FilmRecord& record) {
    const auto& files = c.output.files;
    const fs::path& file = c.resume.empty() ? *std::ranges::find_if(files, isExr) : c.resume;
    try {
        writeFilm(file, record);
        spdlog::debug("saved samples {} to {}", rangesText(record.film.ranges), file.string());
    } catch (const FileError& error) {
        spdlog::warn("no checkpoint: {}", error.what());
    }
}

Rendered renderScene(const RenderCommand& c, const PreparedScene& prepared, const std::atomic<bool>& stop) {
    Rendered result{startFilm(c, prepared), {}, 0, 0};
    const RenderOptions& options = prepared.options;
    result.before = result.record.film.samples();
    const SampleRanges missing = missingFrom({options.sampleBegin, options.sampleEnd}, result.record.film.ranges);
    if (missing.empty()) return result;
    const auto renderer = makeRenderer(prepared.arrays, options, c.backend, !c.stats.empty());
    if (const std::string plan = renderer->memoryPlan(); !plan.empty())
        spdlog::debug("memory on the device:\n{}", plan);
    ProgressBar bar(c.verbosity != Verbosity::Quiet);
    FillControl control;
    control.stop = &stop;
    if (c.timeLimit)
        control.deadline =
            std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                   std::chrono::duration<double>(*c.timeLimit));
    control.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (result.secondsToFirstPass == 0 && done > 0) result.secondsToFirstPass = secondsSinceStart();
        bar.update(done, total);
    };
    control.checkpointSeconds = c.checkpoint;
    control.save = [&](const FilmRecord& record) { saveCheckpoint(c, record); };
    result.report = fillFilm(result.record, *renderer, missing, control);
    return result;
}

void writeStats(const RenderCommand& c, const PreparedScene& prepared, const Rendered& rendered, bool interrupted) {
    const Film& film = rendered.record.film;
    Json stats{{"version", kVersion},
               {"scene", prepared.file.string()},
               {"settings", rendered.record.settings},
               {"settingsHash", settingsHash(rendered.record.settings)},
               {"samples", rangesText(film.ranges)},
               {"spp", film.samples()},
               {"resumedSpp", rendered.before},
               {"interrupted", interrupted},
               {"refusedContributions", film.refused},
               {"refusedInLayers", film.refusedInLayers},
               {"secondsToFirstPass", rendered.secondsToFirstPass},
               {"seconds", prepared.seconds}};
    stats["seconds"]["render"] = rendered.report.renderSeconds;
    stats["seconds"]["total"] = secondsSinceStart();
    stats["peakHostBytes"] = peakHostBytes();
    stats["bvh"] = {{"nodes", prepared.bvh.nodes},
                    {"depth", prepared.bvh.depth},
                    {"sahCost", prepared.bvh.sahCost},
                    {"bytes", prepared.bvh.bytes}};
    stats.update(reportJson(rendered.report));
    writeJsonFile(c.stats, stats);
}

void reportRender(const Rendered& rendered, const RenderOptions& options) {
    const Film& film = rendered.record.film;
    const std::uint32_t added = film.samples() - rendered.before;
    const SampleRanges left = missingFrom({options.sampleBegin, options.sampleEnd}, film.ranges);
    warnOfFilm(rendered.record);
    if (rendered.report.validationMessages > 0)
        spdlog::warn("Vulkan's validation layers said {} things", rendered.report.validationMessages);
    if (!left.empty())
        spdlog::info("stopped after {} of {} samples a pixel", film.samples(), film.samples() + countSamples(left));
    if (rendered.report.renderSeconds > 0)
        spdlog::info("{} samples a pixel in {:.2f} s on {}: {:.2f} M paths/s", added, rendered.report.renderSeconds,
                     rendered.report.device,
                     static_cast<double>(rendered.report.paths) / rendered.report.renderSeconds * 1e-6);
    else
        spdlog::info("all samples are there already");
}

ExitCode runRender(RenderCommand& c) {
    setUpLog(c.verbosity);
    settleOutputs(c);
    const ThreadLimit limit(c.backend.threads);
    const PreparedScene prepared = prepareScene(c.scene, c.sampling);
    const std::atomic<bool>& stop = catchInterrupt();
    spdlog::debug("rendering: Ctrl-C writes the picture so far");
    const Rendered rendered = renderScene(c, prepared, stop);
    const bool interrupted = stop;
    reportRender(rendered, prepared.options);
    writeFilmFiles(rendered.record, c.output);
    if (!c.stats.empty()) writeStats(c, prepared, rendered, interrupted);
    return interrupted ? ExitCode::Interrupted : ExitCode::Ok;
}

std::function<ExitCode()> setUpRender(CLI::App& app) {
    const auto command = std::make_shared<RenderCommand>();
    addSceneFile(app, command->scene, true);
    addSceneOptions(app, command->scene);
    addSamplingOptions(app, command->sampling);
    addAovs(app, command->sampling);
    addLightLayers(app, command->sampling);
    addBackend(app, command->backend);
    addDeviceOptions(app, command->backend);
    addOutputOptions(app, command->output, " (default: NAME.png here)");
    addRunOptions(app, *command);
    return [command] { return runRender(*command); };
}

}  // namespace

const Command kRenderCommand{
    "render", "render a glTF scene to PNG, EXR, HDR or PFM",
    "vkpt render DamagedHelmet.glb --env royal_esplanade_1k.hdr --spp 256 -o helmet.png -o helmet.exr", setUpRender};

}  // namespace vkpt
