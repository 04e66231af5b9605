// vkpt render: a scene to one or more picture files.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "base/atomic_file.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/version.h"
#include "cli/backend.h"
#include "cli/clock.h"
#include "cli/command.h"
#include "cli/metadata.h"
#include "cli/output_name.h"
#include "cli/scene_setup.h"
#include "film/write_image.h"

namespace vkpt {
namespace {

struct RenderCommand {
    SceneOptions scene;
    SamplingOptions sampling;
    BackendOptions backend;
    std::vector<std::filesystem::path> outputs;
    WriteOptions write;
    std::optional<double> timeLimit;  ///< seconds
    std::filesystem::path stats;
    Verbosity verbosity = Verbosity::Normal;
};

void addOutputOptions(CLI::App& app, RenderCommand& c) {
    const char* group = "Output";
    app.add_option("-o,--output", c.outputs,
                   fmt::format("picture to write: {}; may be repeated (default: NAME.png here)", kImageExtensions))
        ->type_name("FILE")
        ->allow_extra_args(false)
        ->group(group);
    addParsed(app, "--exposure", c.write.display.exposure, parseNumber<float>, "EV",
              "of PNG files: 1 EV doubles the light (default: 0)", kReal)
        ->group(group);
    addParsed(app, "--tonemap", c.write.display.toneMap, nameIn(kToneMaps), namesOf(kToneMaps),
              "of PNG files (default: neutral)")
        ->group(group);
    addParsed(
        app, "--bits", c.write.pngBits,
        [](std::string_view text) {
            return text == "8" ? std::optional(8) : text == "16" ? std::optional(16) : std::nullopt;
        },
        "8|16", "of PNG files, a channel (default: 8)")
        ->group(group);
    app.add_option("--stats", c.stats, "write times, rays and memory as JSON")->type_name("FILE")->group(group);
    addParsed(app, "--time-limit", c.timeLimit, numberWithin(std::numeric_limits<double>::min(), 1e9), "S",
              "stop rendering after S seconds, at the end of a pass", kPositive)
        ->group(group);
    addVerbosity(app, c.verbosity);
}

/// Finds out what cannot be written before an hour of rendering, not after.
void checkOutputs(RenderCommand& c) {
    if (c.outputs.empty()) c.outputs.push_back(defaultOutput(c.scene.file));
    for (const auto& output : c.outputs) {
        if (!imageFormat(output))
            throw usageError("--output",
                             fmt::format("'{}' does not end in one of {}", output.string(), kImageExtensions));
        checkWritable(output);
    }
    if (!c.stats.empty()) checkWritable(c.stats);
}

struct Rendered {
    Film film;
    RenderReport report;
    double secondsToFirstPass = 0;
};

Rendered renderScene(const RenderCommand& c, const PreparedScene& prepared, const std::atomic<bool>& stop) {
    Rendered result;
    const auto renderer = makeRenderer(prepared.arrays, prepared.options, c.backend, !c.stats.empty());
    if (const std::string plan = renderer->memoryPlan(); !plan.empty())
        spdlog::debug("memory on the device:\n{}", plan);
    ProgressBar bar(c.verbosity != Verbosity::Quiet);
    RenderControl control;
    control.stop = &stop;
    if (c.timeLimit)
        control.deadline =
            std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                                   std::chrono::duration<double>(*c.timeLimit));
    control.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (result.secondsToFirstPass == 0 && done > 0) result.secondsToFirstPass = secondsSinceStart();
        bar.update(done, total);
    };
    result.film = renderer->render(control, result.report);
    return result;
}

void writePictures(const RenderCommand& c, const PreparedScene& prepared, const Rendered& rendered) {
    const Image image = filmToImage(rendered.film);
    const ImageMetadata metadata = imageMetadata(prepared, rendered.report, rendered.film);
    WriteOptions options = c.write;
    options.display.transparent = prepared.options.params.backgroundMode == kBackgroundTransparent;
    for (const auto& output : c.outputs) {
        writeImage(output, image, options, metadata);
        spdlog::info("wrote {}", output.string());
    }
}

void writeStats(const RenderCommand& c, const PreparedScene& prepared, const Rendered& rendered, bool interrupted) {
    Json stats{{"version", kVersion},
               {"scene", prepared.file.string()},
               {"settings", renderSettings(prepared)},
               {"settingsHash", settingsHash(prepared)},
               {"samples", rangesText(rendered.film.ranges)},
               {"spp", rendered.film.samples()},
               {"interrupted", interrupted},
               {"refusedContributions", rendered.film.refused},
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

void reportRender(const Rendered& rendered, std::uint32_t asked) {
    const Film& film = rendered.film;
    if (film.refused > 0)
        spdlog::warn("{} contributions were NaN, infinite or out of range and do not count", film.refused);
    if (rendered.report.validationMessages > 0)
        spdlog::warn("Vulkan's validation layers said {} things", rendered.report.validationMessages);
    if (film.samples() < asked) spdlog::info("stopped after {} of {} samples a pixel", film.samples(), asked);
    if (rendered.report.renderSeconds > 0)
        spdlog::info("{} samples a pixel in {:.2f} s on {}: {:.2f} M paths/s", film.samples(),
                     rendered.report.renderSeconds, rendered.report.device,
                     static_cast<double>(rendered.report.paths) / rendered.report.renderSeconds * 1e-6);
}

ExitCode runRender(RenderCommand& c) {
    setUpLog(c.verbosity);
    checkOutputs(c);
    const ThreadLimit limit(c.backend.threads);
    const PreparedScene prepared = prepareScene(c.scene, c.sampling);
    const std::atomic<bool>& stop = catchInterrupt();
    spdlog::debug("rendering: Ctrl-C writes the picture so far");
    const Rendered rendered = renderScene(c, prepared, stop);
    const bool interrupted = stop;
    reportRender(rendered, prepared.options.sampleEnd - prepared.options.sampleBegin);
    writePictures(c, prepared, rendered);
    if (!c.stats.empty()) writeStats(c, prepared, rendered, interrupted);
    return interrupted ? ExitCode::Interrupted : ExitCode::Ok;
}

std::function<ExitCode()> setUpRender(CLI::App& app) {
    const auto command = std::make_shared<RenderCommand>();
    addSceneFile(app, command->scene, true);
    addSceneOptions(app, command->scene);
    addSamplingOptions(app, command->sampling);
    addBackend(app, command->backend);
    addDeviceOptions(app, command->backend);
    addOutputOptions(app, *command);
    return [command] { return runRender(*command); };
}

}  // namespace

const Command kRenderCommand{
    "render", "render a glTF scene to PNG, EXR, HDR or PFM",
    "vkpt render DamagedHelmet.glb --env royal_esplanade_1k.hdr --spp 256 -o helmet.png -o helmet.exr", setUpRender};

}  // namespace vkpt
