// vkpt verify: the Vulkan renderer against the CPU reference, rung by rung. Exit 0: they agree; 2: they do not.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <iostream>
#include <memory>

#include "base/progress.h"
#include "base/version.h"
#include "cli/command.h"
#include "cli/metadata.h"
#include "cli/scene_setup.h"
#include "cli/thread_limit.h"
#include "verify/context.h"
#include "verify/ladder.h"
#include "verify/ladder_text.h"
#include "verify/replay.h"
#include "verify/report.h"

namespace vkpt {
namespace {

constexpr float kRows = 72;

struct VerifyCommand {
    SceneOptions scene;
    SamplingOptions sampling;
    BackendOptions backend;
    std::uint32_t replicates = 32;
    std::optional<glm::uvec2> pixel;
    std::filesystem::path report;
    bool json = false;
    Verbosity verbosity = Verbosity::Normal;
};

VerifyConfig configOf(const VerifyCommand& c) {
    VerifyConfig config;
    config.wavefront.device = c.backend.device;
    config.wavefront.validation = c.backend.validate;
    config.wavefront.fetch = c.backend.fetch;
    config.replicates = c.replicates;
    config.threads = c.backend.threads;
    return config;
}

/// Climbs, printing each row once its check is done.
LadderResult climbAndTell(const VerifyCommand& c, VerifyContext& context, std::unique_ptr<ProgressBar>& bar) {
    std::optional<Rung> rung;
    LadderObserver observer;
    observer.before = [&](const Check&) { bar = std::make_unique<ProgressBar>(c.verbosity != Verbosity::Quiet); };
    observer.after = [&](const CheckResult& row) {
        bar.reset();
        if (c.json) return;
        std::cout << ladderRow(row, rung != row.check->rung, c.verbosity == Verbosity::Verbose) << std::flush;
        rung = row.check->rung;
    };
    if (!c.json) std::cout << ladderHeader();
    return climb(context, observer);
}

Json describeRun(const VerifyCommand& c, const PreparedScene& prepared) {
    return {{"version", kVersion},
            {"scene", prepared.file.string()},
            {"settings", renderSettings(prepared)},
            {"samples", {prepared.options.sampleBegin, prepared.options.sampleEnd}},
            {"replicates", c.replicates}};
}

void writeReportFolder(const VerifyCommand& c, const PreparedScene& prepared, VerifyContext& context,
                       const LadderResult& result) {
    const auto metadata = [&](const char* backend, const std::string& device, const Film& film) {
        return imageMetadata({film, renderSettings(prepared), {{film.ranges, backend, device, ""}}});
    };
    const SameSeedImages& same = context.sameSeed();
    const std::string device = context.prober().device().info().name;
    writeReport(context, {.folder = c.report,
                          .title = prepared.file.string(),
                          .settings = describeRun(c, prepared),
                          .ladder = result,
                          .deviceMetadata = metadata("vulkan", device, same.device),
                          .referenceMetadata = metadata("cpu", "CPU reference", same.reference)});
    spdlog::info("wrote {}", (c.report / "index.html").string());
}

ExitCode runLadder(const VerifyCommand& c, const PreparedScene& prepared) {
    const RenderParams& p = prepared.options.params;
    if (!c.json)
        std::cout << fmt::format("{}: {}x{}, {} samples a pixel, seed {}\n", prepared.file.string(), p.width, p.height,
                                 prepared.options.sampleEnd - prepared.options.sampleBegin, p.seed);
    if (!c.report.empty()) makeReportFolder(c.report);
    std::unique_ptr<ProgressBar> bar;
    VerifyConfig config = configOf(c);
    config.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (bar) bar->update(done, total);
    };
    VerifyContext context(prepared.arrays, prepared.options, config);
    const LadderResult result = climbAndTell(c, context, bar);
    if (!c.report.empty()) writeReportFolder(c, prepared, context, result);
    if (context.validationMessages() > 0)
        spdlog::warn("Vulkan's validation layers said {} things", context.validationMessages());
    const CheckResult* failure = result.failure();
    if (c.json) {
        Json report = describeRun(c, prepared);
        report["agrees"] = failure == nullptr;
        if (failure != nullptr)
            report["firstDisagreement"] = kRungs[static_cast<std::size_t>(failure->check->rung)].name;
        report["checks"] = ladderJson(result);
        std::cout << jsonText(report) << '\n';
    } else {
        std::cout << ladderVerdict(result);
    }
    return failure == nullptr ? ExitCode::Ok : ExitCode::Disagree;
}

ExitCode runReplay(const VerifyCommand& c, const PreparedScene& prepared) {
    const RenderParams& p = prepared.options.params;
    if (c.pixel->x >= p.width || c.pixel->y >= p.height)
        throw usageError("--pixel", fmt::format("{},{} is outside the {}x{} pixels of the frame", c.pixel->x,
                                                c.pixel->y, p.width, p.height));
    VerifyContext context(prepared.arrays, prepared.options, configOf(c));
    const auto paths =
        replayPixel(context, c.pixel->x, c.pixel->y, prepared.options.sampleBegin, prepared.options.sampleEnd);
    if (c.json) {
        Json report = describeRun(c, prepared);
        report["pixel"] = {c.pixel->x, c.pixel->y};
        report["paths"] = replayJson(paths);
        std::cout << jsonText(report) << '\n';
    } else {
        std::cout << replayText(paths);
    }
    const bool same = std::ranges::none_of(paths, [](const ReplayPath& path) { return path.parting().has_value(); });
    return same ? ExitCode::Ok : ExitCode::Disagree;
}

ExitCode runVerify(VerifyCommand& c) {
    setUpLog(c.verbosity);
    if (c.sampling.integrator == IntegratorId::Cost)
        throw usageError("--integrator", "cost is no matter for verify: each renderer counts its own search");
    const ThreadLimit limit(c.backend.threads);
    const PreparedScene prepared = prepareScene(c.scene, c.sampling);
    return c.pixel ? runReplay(c, prepared) : runLadder(c, prepared);
}

std::function<ExitCode()> setUpVerify(CLI::App& app) {
    const auto command = std::make_shared<VerifyCommand>();
    command->scene.rows = kRows;
    command->sampling.spp = 4;
    addSceneFile(app, command->scene, true);
    addSceneOptions(app, command->scene);
    addSamplingOptions(app, command->sampling);
    addLightLayers(app, command->sampling);
    addDeviceOptions(app, command->backend);
    addParsed(app, "--replicates", command->replicates, numberWithin(2U), "N",
              "images a side that the last rung compares (default: 32)", "a whole number, 2 or above");
    addParsed(app, "--pixel", command->pixel, parsePixel, "X,Y",
              "replay this pixel's paths on both sides, vertex by vertex, until they part");
    app.add_option("--report", command->report,
                   "write gpu.exr, cpu.exr, diff.png and a page with slider, heat maps and all figures")
        ->type_name("DIR");
    app.add_flag("--json", command->json, "as JSON");
    addVerbosity(app, command->verbosity);
    return [command] { return runVerify(*command); };
}

}  // namespace

const Command kVerifyCommand{"verify", "check the Vulkan renderer against the CPU reference",
                             "vkpt verify scenes/cornell_box/scene.gltf --report proof", setUpVerify};

}  // namespace vkpt
